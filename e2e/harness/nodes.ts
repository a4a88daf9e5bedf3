import {
  BackSide,
  BoxGeometry,
  Color,
  DirectionalLight,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Scene,
} from 'three';
import { RenderTarget, type WebGPURenderer } from 'three/webgpu';
import type { CubeCollider } from 'three-cube-collider';
import { isRigid } from '../../src/collider/isRigid.js';
import { type Backend, createRendering, type Rendering } from '../support/rendering.js';
import { judge, type Surface, type Verdict } from './materialOracle.js';
import { type NodeKind, type NodeKindName, nodeKinds } from './nodeKinds.js';

export interface NodeCase {
  backend: Backend;
  kind: NodeKindName;
}

export interface NodeReport {
  /** As built, and after each change. */
  phases: Verdict[];
  texels: number;
  worst: number;
  /** Programs of the user's own, of the collider for these, and left of these once the materials are disposed of. */
  sources: number;
  programs: number;
  left: number;
  /** Bytes of the user's pictures that differ once the collider has drawn, and bytes that show something. */
  differing: number;
  shown: number;
  /** Which of its meshes may keep their texels between draws. */
  rigid: boolean[];
  warnings: string[];
  seconds: number;
}

/** Of one kind alone: a page's renderers go with each test. */
interface Stage {
  readonly rendering: Rendering;
  readonly collider: CubeCollider;
  readonly scene: Scene;
  readonly room: Mesh;
  readonly camera: PerspectiveCamera;
  readonly target: RenderTarget;
}

async function createStage(backend: Backend): Promise<Stage> {
  const rendering = await createRendering(backend);
  const collider = rendering.collider({ far: 6, resolution: 20 });
  collider.position.set(0.05, 0.02, -0.03);
  const scene = new Scene();
  scene.background = new Color(0x336699);
  const room = new Mesh(new BoxGeometry(6, 6, 6), new MeshBasicMaterial({ side: BackSide }));
  const sun = new DirectionalLight(0xffffff, 2);
  sun.position.set(0.3, 1, 0.5);
  scene.add(room, sun);
  const camera = new PerspectiveCamera(100, 1, 0.05, 20);
  camera.position.set(0.1, 0.5, 1.9);
  camera.lookAt(0, 0, -1);
  const target = new RenderTarget(32, 32);
  // As a material's own outputs call it.
  target.texture.name = 'output';
  const made = { rendering, collider, scene, room, camera, target };
  // The programs that all kinds share, the user's of the room and background too.
  await rendering.see(collider, scene);
  await picture(made);
  return made;
}

/** What the user sees of the scene, without the collider. */
async function picture({ rendering, scene, camera, target }: Stage): Promise<Uint8Array> {
  const renderer = rendering.renderer as unknown as WebGPURenderer;
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  renderer.setRenderTarget(null);
  const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, 32, 32);
  return Uint8Array.from(pixels as Uint8Array);
}

/** A kind of material or object as the collider sees it, phase by phase, and as its app goes on seeing it. */
export default async function nodes({ backend, kind: name }: NodeCase): Promise<NodeReport> {
  const start = performance.now();
  const warnings: string[] = [];
  const { warn } = console;
  console.warn = (...words: unknown[]) => warnings.push(words.join(' '));
  try {
    const stage = await createStage(backend);
    const report = await see(stage, name);
    stage.collider.dispose();
    stage.rendering.renderer.dispose();
    return { ...report, warnings, seconds: (performance.now() - start) / 1000 };
  } finally {
    console.warn = warn;
  }
}

async function see(
  stage: Stage,
  name: NodeKindName,
): Promise<Omit<NodeReport, 'warnings' | 'seconds'>> {
  const { rendering, collider, scene, room } = stage;
  const renderer = rendering.renderer as unknown as WebGPURenderer;
  const programs = () => renderer.info.memory.programs;
  const before = programs();
  const kind: NodeKind = nodeKinds[name](renderer as never);
  const objects = kind.objects ?? kind.surfaces.map(({ mesh }) => mesh);
  scene.add(...objects);
  const surfaces: Surface[] = [...kind.surfaces, { mesh: room, room: true }];
  const phases: Verdict[] = [];
  const pictures = { differing: 0, shown: 0 };
  let sources = programs() - before;
  for (let phase = 0; phase <= kind.changes.length; phase++) {
    const then = programs();
    if (phase > 0) kind.changes[phase - 1]!();
    const alone = await picture(stage);
    sources += programs() - then;
    await rendering.see(collider, scene);
    phases.push(judge(collider.field!, collider.near, collider.supersample, surfaces));
    compare(alone, await picture(stage), pictures);
  }
  const rigid = [...new Set(kind.surfaces.map(({ mesh }) => isRigid(mesh)))];
  const own = programs() - before - sources;
  scene.remove(...objects);
  for (const material of kind.materials) material.dispose();
  for (const { mesh } of kind.surfaces) mesh.geometry.dispose();
  for (const compute of kind.computes ?? []) compute.dispose();
  const left = programs() - before;
  const sum = (key: keyof Verdict) => phases.reduce((all, each) => all + each[key], 0);
  return {
    phases,
    texels: sum('texels'),
    worst: Math.max(...phases.map(({ worst }) => worst)),
    sources,
    programs: own,
    left,
    ...pictures,
    rigid,
  };
}

function compare(
  alone: Uint8Array,
  beside: Uint8Array,
  pictures: { differing: number; shown: number },
): void {
  for (let i = 0; i < alone.length; i++) {
    if (alone[i] !== beside[i]) pictures.differing++;
    if (alone[i] !== alone[i % 4]) pictures.shown++;
  }
}
