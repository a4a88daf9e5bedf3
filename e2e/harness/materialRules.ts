import {
  BackSide,
  BoxGeometry,
  BufferGeometry,
  DirectionalLight,
  DoubleSide,
  FrontSide,
  Line,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshMatcapMaterial,
  MeshNormalMaterial,
  MeshPhongMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  MeshToonMaterial,
  type Object3D,
  PerspectiveCamera,
  PlaneGeometry,
  Points,
  PointsMaterial,
  Scene,
  ShaderMaterial,
  type ShaderMaterialParameters,
  Sprite,
  Texture,
  WebGLRenderer,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { CubeCollider, type CubeColliderOptions } from 'three-cube-collider';
import { kinds } from './materialKinds.js';

const SHADER: ShaderMaterialParameters = {
  vertexShader:
    'void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 ); }',
  fragmentShader: 'void main() { gl_FragColor = vec4( 1.0 ); }',
};

/** A pane a metre ahead (-Z), that shows its front. */
function pane(material: Material, size = 1): Mesh {
  const mesh = new Mesh(new PlaneGeometry(size, size), material);
  mesh.position.z = -1;
  return mesh;
}

function colliderOf(options: CubeColliderOptions = {}): CubeCollider {
  return new CubeCollider({ far: 3, resolution: 16, readback: 'sync', ...options });
}

/** How many texels see anything, the largest error of those against a pane at z = -1, and how the middle faces. */
function look(collider: CubeCollider, renderer: WebGLRenderer, scene: Object3D, z = -1) {
  collider.update(renderer, scene);
  const { distance, direction, front, count, resolution } = collider.field!;
  let seen = 0;
  let worst = 0;
  for (let i = 0; i < count; i++) {
    if (distance[i] === Infinity) continue;
    seen++;
    worst = Math.max(worst, Math.abs(distance[i]! * direction[3 * i + 2]! - z));
  }
  const middle = (5 * resolution + resolution / 2) * resolution + resolution / 2;
  return { seen, worst, front: front[middle] === 1 };
}

const things: Record<string, () => Object3D> = {
  opaque: () => pane(new MeshBasicMaterial()),
  transparent: () => pane(new MeshBasicMaterial({ transparent: true, opacity: 0.4 })),
  'transparent shader': () => pane(new ShaderMaterial({ ...SHADER, transparent: true })),
  'transparent, alpha tested': () =>
    pane(new MeshBasicMaterial({ transparent: true, alphaTest: 0.5 })),
  'no depth written': () => pane(new MeshBasicMaterial({ depthWrite: false })),
  'not visible': () => {
    const mesh = pane(new MeshBasicMaterial());
    mesh.visible = false;
    return mesh;
  },
  'a material that is not visible': () => pane(new MeshBasicMaterial({ visible: false })),
  sprite: () => {
    const sprite = new Sprite();
    sprite.position.z = -1;
    return sprite;
  },
  points: () => {
    const points = new Points(new PlaneGeometry(1, 1, 20, 20), new PointsMaterial({ size: 1 }));
    points.position.z = -1;
    return points;
  },
  line: () => {
    const line = new Line(new PlaneGeometry(1, 1, 20, 20));
    line.position.z = -1;
    return line;
  },
  'wide line': () => {
    const geometry = new LineSegmentsGeometry().setPositions([-1, 0, -1, 1, 0, -1]);
    return new LineSegments2(geometry, new LineMaterial({ linewidth: 40 }));
  },
};

const cases = {
  /** Texels that see each thing: by default, with `transparent: 'solid'`, and marked as solid or as a ghost. */
  policy() {
    const renderer = new WebGLRenderer();
    const table: Record<string, number[]> = {};
    let worst = 0;
    const colliders = [colliderOf(), colliderOf({ transparent: 'solid' })] as const;
    for (const [name, make] of Object.entries(things)) {
      const thing = make();
      const scene = new Scene().add(thing);
      const count = (collider: CubeCollider, mark?: boolean) => {
        thing.userData.collider = mark;
        const report = look(collider, renderer, scene);
        worst = Math.max(worst, report.worst);
        return report.seen;
      };
      table[name] = [
        count(colliders[0]),
        count(colliders[1]),
        count(colliders[0], true),
        count(colliders[1], false),
      ];
    }
    for (const collider of colliders) collider.dispose();
    renderer.dispose();
    return { table, worst };
  },

  /** By either rule of sides: which sides of shader and cut materials are seen, mirrored ones too. */
  sides() {
    const renderer = new WebGLRenderer();
    const told: string[] = [];
    for (const sides of ['both', 'drawn'] as const) {
      const collider = colliderOf({ sides });
      for (const [name, side] of Object.entries({ FrontSide, BackSide, DoubleSide })) {
        const materials = [
          new MeshBasicMaterial({ side }),
          new ShaderMaterial({ ...SHADER, side }),
          new MeshBasicMaterial({ side, alphaTest: 0.5 }),
        ];
        const views = materials.map((material) => {
          const mesh = pane(material);
          const scene = new Scene().add(mesh);
          return [1, -1].flatMap((mirror) =>
            [0, Math.PI].map((turn) => {
              mesh.scale.x = mirror;
              mesh.rotation.y = turn;
              const { seen, front } = look(collider, renderer, scene);
              return seen === 0 ? 'nothing' : front ? 'front' : 'back';
            }),
          );
        });
        const [plain, ...others] = views.map((each) => each.join(' '));
        told.push(`${sides} ${name}: ${others.every((each) => each === plain) ? plain : views}`);
      }
      collider.dispose();
    }
    renderer.dispose();
    return told;
  },

  /** A shader that compiles only in a scene with a light: what is seen, said, left of the state, and made. */
  async unwrappable({ compile }: { compile: boolean }) {
    const renderer = new WebGLRenderer();
    const material = new ShaderMaterial({
      name: 'lava',
      lights: true,
      uniforms: kindsOfLight(),
      vertexShader: `
        void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4( position.xy, position.z + 0.3, 1.0 ); }`,
      fragmentShader: `
        #include <common>
        #include <lights_pars_begin>
        void main() { gl_FragColor = vec4( directionalLights[ 0 ].color, 1.0 ); }`,
    });
    const scene = new Scene().add(pane(material), new DirectionalLight());
    renderer.setSize(16, 16);
    renderer.render(scene, new PerspectiveCamera());
    renderer.debug.checkShaderErrors = false;
    const warnings: string[] = [];
    const { warn } = console;
    console.warn = (...words: unknown[]) => warnings.push(words.join(' '));
    const collider = colliderOf();
    if (compile) await collider.compile(renderer, scene);
    const before = renderer.info.programs!.length;
    const views = [0, 1, 2].map(() => look(collider, renderer, scene));
    // An app that makes a new version of it at every draw.
    scene.children[0]!.onBeforeRender = () => (material.needsUpdate = true);
    for (let i = 0; i < 4; i++) {
      material.needsUpdate = true;
      views.push(look(collider, renderer, scene));
    }
    const made = renderer.info.programs!.length - before;
    console.warn = warn;
    const { checkShaderErrors, onShaderError } = renderer.debug;
    material.dispose();
    collider.dispose();
    const left = renderer.info.programs!.length;
    const error = renderer.getContext().getError();
    renderer.dispose();
    return {
      views,
      made,
      left,
      error,
      debug: [checkShaderErrors, onShaderError],
      warnings: warnings.filter((each) => each.startsWith('CubeCollider')),
    };
  },

  /** Programs for a dozen materials that change neither shape nor coverage. */
  plain() {
    const renderer = new WebGLRenderer();
    const map = new Texture();
    const materials = [
      new MeshBasicMaterial({ map }),
      new MeshLambertMaterial({ side: BackSide }),
      new MeshPhongMaterial({ normalMap: map }),
      new MeshToonMaterial(),
      new MeshStandardMaterial({ roughnessMap: map, side: DoubleSide }),
      new MeshPhysicalMaterial({ transmission: 0.5, clearcoat: 1 }),
      new MeshMatcapMaterial(),
      new MeshNormalMaterial({ flatShading: true }),
    ];
    const scene = new Scene().add(...materials.map((material) => pane(material)));
    const collider = colliderOf({ supersample: 1 });
    collider.update(renderer, scene);
    const programs = renderer.info.programs!.length;
    const { objects } = collider.stats;
    collider.dispose();
    renderer.dispose();
    return { programs, objects };
  },

  /** Programs that the first update still makes once all kinds were compiled; and those left as things are disposed of. */
  async compiled() {
    const renderer = new WebGLRenderer();
    const all = [
      kinds.displacement(),
      kinds['alpha test'](),
      kinds.onBeforeCompile(),
      kinds.ShaderMaterial(),
      kinds['RawShaderMaterial, GLSL 1'](),
    ];
    const scene = new Scene().add(
      new Mesh(new BoxGeometry(5, 5, 5), new MeshBasicMaterial()),
      ...all.flatMap(({ surfaces }) => surfaces.map(({ mesh }) => mesh)),
    );
    const collider = colliderOf();
    await collider.compile(renderer, scene);
    const count = () => renderer.info.programs!.length;
    const compiled = count();
    collider.update(renderer, scene);
    const made = count() - compiled;
    // Disposed of by the app and used on, then by another collider too, then disposed of for good.
    const dispose = () =>
      all.forEach(({ materials }) => materials.forEach((each) => each.dispose()));
    dispose();
    const afterDispose = count();
    const other = colliderOf();
    collider.update(renderer, scene);
    other.update(renderer, scene);
    const used = count();
    other.dispose();
    collider.update(renderer, scene);
    const afterOther = count();
    dispose();
    const left = count();
    collider.dispose();
    const end = count();
    const listeners = all
      .flatMap(({ materials }) => materials)
      .filter((material) => {
        const { _listeners } = material as unknown as { _listeners?: { dispose?: unknown[] } };
        return (_listeners?.dispose?.length ?? 0) > 0;
      }).length;
    renderer.dispose();
    return { compiled, made, afterDispose, used, afterOther, left, end, listeners };
  },

  /** The paper's reds of a pane, in a plain, a shader and a cut material. */
  axis() {
    const renderer = new WebGLRenderer();
    const collider = colliderOf({ output: 'axis', far: undefined });
    const reds = [
      new MeshBasicMaterial(),
      new ShaderMaterial(SHADER),
      new MeshBasicMaterial({ alphaTest: 0.5 }),
    ].map((material) => {
      const mesh = pane(material, 0.3);
      mesh.position.set(0.03, 0.02, -0.25);
      collider.update(renderer, new Scene().add(mesh));
      return [...collider.maxima!.red];
    });
    collider.dispose();
    renderer.dispose();
    return reds;
  },

  /** The same cut and shader materials once more, after the app has changed what they are. */
  changedKinds() {
    const renderer = new WebGLRenderer();
    const collider = colliderOf();
    const material = new MeshStandardMaterial();
    const mesh = pane(material);
    const scene = new Scene().add(mesh);
    const seen = [look(collider, renderer, scene, -1)];
    material.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader.replace(
        '#include <begin_vertex>',
        'vec3 transformed = position + vec3( 0.0, 0.0, 0.25 );',
      );
    };
    material.needsUpdate = true;
    seen.push(look(collider, renderer, scene, -0.75));
    material.onBeforeCompile = Object.getPrototypeOf(
      MeshStandardMaterial.prototype,
    ).onBeforeCompile;
    material.alphaTest = 0.5;
    material.needsUpdate = true;
    seen.push(look(collider, renderer, scene, -1));
    material.opacity = 0.4;
    seen.push(look(collider, renderer, scene, -1));
    mesh.geometry = new BufferGeometry();
    collider.dispose();
    renderer.dispose();
    return seen;
  },
};

/** Uniforms of a shader with `lights: true`, without the fog that three merges in. */
function kindsOfLight() {
  const light = { value: [] };
  const names = [
    'ambientLightColor', 'lightProbe', 'directionalLights', 'directionalLightShadows', 'directionalShadowMap',
    'directionalShadowMatrix', 'spotLights', 'spotLightShadows', 'spotLightMap', 'spotShadowMap', 'spotLightMatrix',
    'pointLights', 'pointLightShadows', 'pointShadowMap', 'pointShadowMatrix', 'hemisphereLights', 'rectAreaLights',
    'ltc_1', 'ltc_2', 'sunLights', 'sunLightShadows', 'sunShadowMap', 'sunShadowMatrix', 'sunShadowCascade',
    'probesSH', 'probesMin', 'probesMax', 'probesResolution',
  ]; // prettier-ignore
  return Object.fromEntries(names.map((name) => [name, { ...light }]));
}

export type RuleCases = typeof cases;

export default function materialRules({ name, args }: { name: keyof RuleCases; args?: unknown }) {
  return (cases[name] as (args: unknown) => unknown)(args);
}
