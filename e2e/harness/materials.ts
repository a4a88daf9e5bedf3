import {
  BackSide,
  BoxGeometry,
  Color,
  DirectionalLight,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  type Plane,
  Scene,
  WebGLRenderer,
  WebGLRenderTarget,
  type WebGLRendererParameters,
} from 'three';
import { CubeCollider, type CubeColliderOptions } from 'three-cube-collider';
import { type Kind, kinds, type KindName } from './materialKinds.js';
import { judge, type Surface, type Verdict } from './materialOracle.js';

export interface KindCase {
  kind: KindName;
  collider?: CubeColliderOptions;
  renderer?: WebGLRendererParameters;
  /** Does the collider draw before the app does? */
  probeFirst?: boolean;
}

export interface KindReport extends Verdict {
  kind: KindName;
  /** As built, and after each change. */
  phases: Verdict[];
  /** Draw calls of the kind's four meshes. */
  draws: number;
  /** Programs that the collider made for the kind, for as many of the app's own. */
  programs: number;
  sources: number;
  /** Programs left once the kind's materials are disposed of. */
  left: number;
  /** Bytes of the app's own pictures that differ from those of an app without a collider. */
  differing: number;
  /** Bytes that are not the background's. */
  shown: number;
  warnings: string[];
  seconds: number;
}

/** An app with one kind of material in a room, that renders for itself. */
class App {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(100, 1, 0.05, 20);
  readonly target = new WebGLRenderTarget(32, 32);
  readonly room = new Mesh(new BoxGeometry(6, 6, 6), new MeshBasicMaterial({ side: BackSide }));
  readonly kind: Kind;

  constructor(name: KindName, parameters: WebGLRendererParameters = {}) {
    this.renderer = new WebGLRenderer(parameters);
    this.scene.background = new Color(0x336699);
    const sun = new DirectionalLight(0xffffff, 2);
    sun.position.set(0.3, 1, 0.5);
    this.kind = kinds[name](this.renderer);
    this.room.visible = false;
    this.scene.add(this.room, sun, ...this.kind.surfaces.map(({ mesh }) => mesh));
    this.camera.position.set(0.1, 0.5, 1.9);
    this.camera.lookAt(0, 0, -1);
  }

  /** The app's own picture, of the kind alone. */
  frame(): Uint8Array {
    const { renderer, target } = this;
    this.room.visible = false;
    renderer.setRenderTarget(target);
    renderer.render(this.scene, this.camera);
    const pixels = new Uint8Array(4 * 32 * 32);
    renderer.readRenderTargetPixels(target, 0, 0, 32, 32, pixels);
    renderer.setRenderTarget(null);
    this.room.visible = true;
    return pixels;
  }

  dispose(): void {
    for (const material of this.kind.materials) material.dispose();
    this.target.dispose();
    this.renderer.dispose();
  }
}

/** The collider's own programs, but for those that all share. */
function derivedPrograms(renderer: WebGLRenderer): number {
  return renderer.info.programs!.filter(
    ({ name }) => name.startsWith('CubeCollider ') && !/ (surface|axis|nearest)$/.test(name),
  ).length;
}

/** A kind of material as the collider sees it, phase by phase, and as its app goes on seeing it. */
export function drawKind(test: KindCase): KindReport {
  const start = performance.now();
  const app = new App(test.kind, test.renderer);
  const twin = new App(test.kind, test.renderer);
  const { renderer, scene, kind, room } = app;
  const collider = new CubeCollider({ far: 6, resolution: 20, readback: 'sync', ...test.collider });
  collider.position.set(0.05, 0.02, -0.03);
  const warnings: string[] = [];
  const { warn } = console;
  console.warn = (...words: unknown[]) => warnings.push(words.join(' '));

  const pictures = { differing: 0, shown: 0 };
  const compare = () => {
    const mine = app.frame();
    const theirs = twin.frame();
    for (let i = 0; i < mine.length; i++) {
      if (mine[i] !== theirs[i]) pictures.differing++;
      if (mine[i] !== mine[i % 4]) pictures.shown++;
    }
  };
  const phases: Verdict[] = [];
  const surfaces: Surface[] = [
    ...kind.surfaces,
    {
      mesh: room,
      room: true,
      there: ({ point }) =>
        renderer.clippingPlanes.every((plane: Plane) => plane.distanceToPoint(point) >= 0),
    },
  ];
  for (let phase = 0; phase <= kind.changes.length; phase++) {
    if (phase > 0) {
      kind.changes[phase - 1]!();
      twin.kind.changes[phase - 1]!();
    }
    if (test.probeFirst !== true && phase === 0) compare();
    room.visible = true;
    collider.update(renderer, scene);
    phases.push(judge(collider.field!, collider.near, collider.supersample, surfaces));
    compare();
  }
  console.warn = warn;
  const { drawCalls } = collider.stats;
  const programs = derivedPrograms(renderer);
  const sources = new Set<unknown>();
  for (const material of kind.materials) {
    const { programs } = renderer.properties.get(material) as { programs: Map<string, unknown> };
    for (const program of programs.values()) sources.add(program);
  }
  for (const { mesh } of kind.surfaces) mesh.visible = false;
  collider.update(renderer, scene);
  const draws = drawCalls - collider.stats.drawCalls;
  for (const material of kind.materials) material.dispose();
  const left = derivedPrograms(renderer);
  collider.dispose();
  app.dispose();
  twin.dispose();
  const sum = (key: keyof Verdict) => phases.reduce((all, each) => all + each[key], 0);
  return {
    kind: test.kind,
    ...pictures,
    phases,
    texels: sum('texels'),
    worst: Math.max(...phases.map(({ worst }) => worst)),
    wrong: sum('wrong'),
    strangers: sum('strangers'),
    silhouettes: sum('silhouettes'),
    draws,
    programs,
    sources: sources.size,
    left,
    warnings: warnings.filter((each) => !each.includes('KHR_parallel_shader_compile')),
    seconds: (performance.now() - start) / 1000,
  };
}

export default function materials(tests: KindCase[]): KindReport[] {
  return tests.map(drawKind);
}
