import { LoadingManager, type WebGLRenderer } from 'three';
import type { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import type { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';
import dracoScript from 'three/addons/libs/draco/gltf/draco_wasm_wrapper.js?url';
import dracoBinary from 'three/addons/libs/draco/gltf/draco_decoder.wasm?url';
import basisScript from 'three/addons/libs/basis/basis_transcoder.js?url';
import basisBinary from 'three/addons/libs/basis/basis_transcoder.wasm?url';
import type { GltfJson } from './inspect.js';

/** Each begun once, by the first file that needs it; its workers are kept for the next. */
let draco: Promise<DRACOLoader> | null = null;
let ktx2: Promise<KTX2Loader> | null = null;

/**
 * Gives a loader what a file is compressed with: the decoders come from this page's own origin, when they are needed.
 *
 * Under a content security policy they ask for `script-src 'wasm-unsafe-eval'`, `worker-src blob:` and
 * `connect-src 'self' blob: data:`; KTX2's transcoder as three ships it for 'unsafe-eval' too, as Embind makes functions of
 * text, which the build mends (scripts/demo/decoders.mjs).
 */
export async function addDecoders(
  loader: GLTFLoader,
  { extensionsUsed = [] }: GltfJson,
  renderer: WebGLRenderer,
): Promise<void> {
  const uses = (name: string) => extensionsUsed.includes(name);
  if (uses('KHR_draco_mesh_compression')) loader.setDRACOLoader(await (draco ??= makeDraco()));
  if (uses('KHR_texture_basisu')) {
    const textures = await (ktx2 ??= makeKtx2(renderer));
    redirect(textures, loader);
    loader.setKTX2Loader(textures);
  }
  if (uses('EXT_meshopt_compression') || uses('KHR_meshopt_compression')) {
    const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
    loader.setMeshoptDecoder(MeshoptDecoder);
  }
}

async function makeDraco(): Promise<DRACOLoader> {
  const { DRACOLoader } = await import('three/addons/loaders/DRACOLoader.js');
  return new DRACOLoader().setDecoderPath({ js: dracoScript, wasm: dracoBinary }).setWorkerLimit(2);
}

async function makeKtx2(renderer: WebGLRenderer): Promise<KTX2Loader> {
  const { KTX2Loader } = await import('three/addons/loaders/KTX2Loader.js');
  return new KTX2Loader(new LoadingManager())
    .setTranscoderPath('decoder:/')
    .setWorkerLimit(2)
    .detectSupport(renderer);
}

/** It asks for its decoder by name, and for pictures as the level's own loader would. */
function redirect(loader: KTX2Loader, { manager }: GLTFLoader): void {
  const decoder: Record<string, string> = {
    'decoder:/basis_transcoder.js': basisScript,
    'decoder:/basis_transcoder.wasm': basisBinary,
  };
  loader.manager.setURLModifier((url) => decoder[url] ?? manager.resolveURL(url));
}
