import {
  BackSide,
  BoxGeometry,
  DoubleSide,
  FrontSide,
  InstancedMesh,
  Material,
  LinearMipmapLinearFilter,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshNormalMaterial,
  Object3D,
  Plane,
  PlaneGeometry,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';
import {
  ClippingGroup,
  type ComputeNode,
  MeshBasicNodeMaterial,
  MeshLambertNodeMaterial,
  MeshPhysicalNodeMaterial,
  MeshStandardNodeMaterial,
  type Node,
  NodeMaterial,
  StorageBufferAttribute,
  StorageInstancedBufferAttribute,
  type WebGPURenderer,
} from 'three/webgpu';
import {
  cameraProjectionMatrix,
  cameraViewMatrix,
  Discard,
  float,
  Fn,
  instancedArray,
  instanceIndex,
  modelViewMatrix,
  modelWorldMatrix,
  mrt,
  output,
  positionGeometry,
  positionLocal,
  positionView,
  positionWorld,
  storage,
  texture,
  uniform,
  uv,
  vec3,
  vec4,
} from 'three/tsl';
import type { Hit } from './materialOracle.js';
import {
  type Kind as MaterialKind,
  kinds as materialKinds,
  patches,
  Picture,
  plane,
  put,
  stripes,
  surfacesOf,
  type There,
  uvOf,
  wave,
  waves,
} from './materialKinds.js';

/** As for `WebGLRenderer`; what moves or cuts may also be an object, or come from a compute shader. */
export interface NodeKind extends MaterialKind {
  /** What to put into the scene, where it is not the surfaces' meshes. */
  readonly objects?: Object3D[];
  /** What it computes with. */
  readonly computes?: ComputeNode[];
}

type MakeNodeKind = (renderer: WebGPURenderer) => NodeKind;

/** As `wave`. */
const waved = (time: Node<'float'>) =>
  positionGeometry.add(vec3(0, 0, positionGeometry.x.mul(6).add(time).sin().mul(0.15)));
/** True where nothing is, as `stripes`. */
const gap = () => uv().x.mul(4).add(0.5).fract().lessThan(0.3);

function moved(): NodeKind {
  const time = uniform(0.4);
  const material = new MeshStandardNodeMaterial();
  material.positionNode = waved(time);
  let flat = false;
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(), material), {
      place: (position, i) => {
        if (flat) position.z += 0.3;
        else wave(() => time.value)(position, i);
      },
    }),
    changes: [
      () => (time.value = 1.7),
      () => {
        flat = true;
        material.positionNode = positionLocal.add(vec3(0, 0, 0.3));
        material.needsUpdate = true;
      },
    ],
  };
}

/** By a wind that blows through the world, told once a draw. */
function blown(): NodeKind {
  let now = 0.2;
  const time = uniform(0).onRenderUpdate(() => now);
  const material = new MeshLambertNodeMaterial({ side: DoubleSide });
  material.positionNode = positionLocal.add(
    vec3(0, 0, positionWorld.x.mul(3).add(time).sin().mul(0.2)),
  );
  const meshes = put(plane(), material);
  const world = new Vector3();
  return {
    materials: [material],
    surfaces: meshes.map((mesh) => ({
      mesh,
      place: (position) => {
        world.copy(position).applyMatrix4(mesh.matrixWorld);
        position.z += 0.2 * Math.sin(3 * world.x + now);
      },
    })),
    changes: [() => (now = 2)],
  };
}

function projected(): NodeKind {
  const time = uniform(0.3);
  const material = new MeshBasicNodeMaterial();
  material.vertexNode = cameraProjectionMatrix.mul(modelViewMatrix).mul(vec4(waved(time), 1));
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(), material), { place: wave(() => time.value) }),
    changes: [() => (time.value = 2)],
  };
}

/** With what three has worked out of the vertex already. */
function projectedFromView(): NodeKind {
  const lift = uniform(0.25);
  const material = new MeshStandardNodeMaterial();
  material.vertexNode = cameraProjectionMatrix.mul(
    vec4(positionView.add(cameraViewMatrix.mul(vec4(0, lift, 0, 0)).xyz), 1),
  );
  const meshes = put(plane(2), material);
  const world = new Vector3();
  return {
    materials: [material],
    surfaces: meshes.map((mesh) => ({
      mesh,
      place: (position) => {
        world.copy(position).applyMatrix4(mesh.matrixWorld);
        world.y += lift.value;
        position.copy(world.applyMatrix4(mesh.matrixWorld.clone().invert()));
      },
    })),
    changes: [() => (lift.value = -0.2)],
  };
}

function masked(): NodeKind {
  const picture = patches(6, 3);
  const level = uniform(0.5);
  const material = new MeshStandardNodeMaterial();
  material.maskNode = texture(picture.texture).a.greaterThan(level);
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(1), material), {
      there: (hit) => picture.at(uvOf(hit), 3) > level.value,
    }),
    changes: [
      () => (level.value = 0.9),
      () => {
        material.maskNode = texture(picture.texture).a.greaterThan(0.2);
        material.needsUpdate = true;
        level.value = 0.2;
      },
    ],
  };
}

function alphaTested(): NodeKind {
  const picture = patches(6, 4);
  const level = uniform(0.5);
  const opacity = uniform(1);
  const material = new MeshLambertNodeMaterial({ transparent: true });
  material.opacityNode = texture(picture.texture).a.mul(opacity);
  material.alphaTestNode = level;
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(1), material), {
      there: (hit) => opacity.value * picture.at(uvOf(hit), 3) > level.value,
    }),
    changes: [() => (level.value = 0.9), () => ((opacity.value = 0.6), (level.value = 0.3))],
  };
}

function colorDiscards(): NodeKind {
  const material = new MeshStandardNodeMaterial();
  const shift = uniform(0);
  material.colorNode = Fn(() => {
    Discard(uv().x.mul(4).add(0.5).add(shift).fract().lessThan(0.3));
    return vec4(1, 0.5, 0.2, 1);
  })();
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(1), material), { there: shifted(() => shift.value) }),
    changes: [() => (shift.value = 0.15)],
  };
}

/** `stripes`, farther on. */
const shifted =
  (shift: () => number): There =>
  (hit) => {
    const along = 4 * uvOf(hit)[0]! + 0.5 + shift();
    return along - Math.floor(along) >= 0.3;
  };

function outputDiscards(): NodeKind {
  let whole = false;
  const material = new MeshStandardNodeMaterial({ color: 0x88aacc });
  material.outputNode = Fn(() => {
    Discard(gap());
    return output.mul(0.9);
  })();
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(1), material), { there: (hit) => whole || stripes(hit) }),
    changes: [
      () => {
        material.outputNode = null;
        material.needsUpdate = true;
        whole = true;
      },
    ],
  };
}

/** Of a material with a fragment node three asks neither its mask nor its alpha. */
function fragmentDiscards(): NodeKind {
  let whole = false;
  const material = new MeshBasicNodeMaterial({ alphaTest: 0.5, opacity: 0.2 });
  material.maskNode = uv().y.greaterThan(2);
  material.fragmentNode = Fn(() => {
    Discard(gap());
    return vec4(uv(), 0, 1);
  })();
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(1), material), { there: (hit) => whole || stripes(hit) }),
    changes: [
      () => {
        material.fragmentNode = vec4(1, 0, 0, 0);
        material.needsUpdate = true;
        whole = true;
      },
    ],
  };
}

/** A bare `NodeMaterial`, whose color node is all it has. */
function mrtAlone(): NodeKind {
  const material = new NodeMaterial();
  material.colorNode = vec4(0.2, 0.9, 0.4, 1);
  material.mrtNode = mrt({ output: vec4(1, 0, 0, 1) });
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(2), material), {}),
    changes: [
      () => {
        material.mrtNode = mrt({ output: vec4(0, 1, 0, 1) });
        material.needsUpdate = true;
      },
    ],
  };
}

/** A fence so fine that the smaller images of its map are all thin air; three's nodes read its red. */
function alphaMapped(): NodeKind {
  const picture = new Picture(64, false, (x, y) => {
    const value = x % 16 < 5 || y % 16 < 5 ? 255 : 0;
    return [value, 0, 0, 255];
  });
  picture.texture.generateMipmaps = true;
  picture.texture.minFilter = LinearMipmapLinearFilter;
  const material = new MeshLambertMaterial({ alphaMap: picture.texture, alphaTest: 0.7 });
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(1), material), {
      there: (hit) => material.opacity * picture.at(uvOf(hit), 0) > material.alphaTest,
    }),
    changes: [() => picture.texture.repeat.set(0.5, 0.7)],
  };
}

function displaced(): NodeKind {
  const pictures = [waves(16, 0), waves(16, 1.5)];
  let picture = pictures[0]!;
  const material = new MeshStandardNodeMaterial({
    displacementMap: picture.texture,
    displacementScale: 0.3,
    displacementBias: -0.1,
  });
  const geometry = plane();
  const at = geometry.attributes.uv!;
  return {
    materials: [material],
    surfaces: surfacesOf(put(geometry, material), {
      place: (position, i) => {
        const height = picture.at([at.getX(i), at.getY(i)], 0);
        position.z += material.displacementScale * height + material.displacementBias;
      },
    }),
    changes: [
      () => (material.displacementScale = -0.25),
      () => (material.displacementMap = (picture = pictures[1]!).texture),
      () => picture.texture.offset.set(0.3, 0.1),
    ],
  };
}

const COUNT = 7;

/** No instance matrices: a plain mesh with a count, each put where a storage buffer says. */
function counted(renderer: WebGPURenderer): NodeKind {
  const places = Array.from({ length: COUNT }, (_, i) => placeOf(i));
  const array = new Float32Array(4 * COUNT);
  places.forEach((place, i) => place.toArray(array, 4 * i));
  const buffer = new StorageInstancedBufferAttribute(array, 4);
  const stored = storage(buffer, 'vec4', COUNT);
  const shift = uniform(0);
  const compute = Fn(() => {
    stored.element(instanceIndex).x.addAssign(shift);
  })().compute(COUNT) as ComputeNode;
  const material = new MeshStandardNodeMaterial();
  material.positionNode = positionLocal.add(stored.element(instanceIndex).xyz);
  const mesh = new Mesh(new SphereGeometry(0.3, 10, 8), material);
  mesh.count = COUNT;
  mesh.frustumCulled = false;
  mesh.position.set(0.1, 0, 0);
  mesh.rotation.set(0.1, 0.2, 0.3);
  return {
    materials: [material],
    surfaces: places.map((place, instance) => ({
      mesh,
      instance,
      place: (position) => void position.add(place),
      there: () => instance < mesh.count!,
    })),
    objects: [mesh],
    computes: [compute],
    changes: [
      () => {
        shift.value = 0.17;
        renderer.compute(compute);
        for (const place of places) place.x += 0.17;
      },
      () => (mesh.count = 5),
    ],
  };
}

/** The same by `instancedArray`, which a compute shader fills. */
function computedInstances(renderer: WebGPURenderer): NodeKind {
  const stored = instancedArray(COUNT, 'vec3');
  const turn = uniform(0.5);
  const compute = Fn(() => {
    const angle = float(instanceIndex).add(turn).toVar();
    stored.element(instanceIndex).assign(vec3(angle.cos(), angle.sin().mul(0.4), angle.sin()));
  })().compute(COUNT) as ComputeNode;
  renderer.compute(compute);
  const material = new MeshBasicNodeMaterial();
  material.positionNode = positionLocal.add(stored.element(instanceIndex));
  const mesh = new Mesh(new BoxGeometry(0.6, 0.5, 0.4), material);
  mesh.count = COUNT;
  mesh.frustumCulled = false;
  return {
    materials: [material],
    surfaces: Array.from({ length: COUNT }, (_, instance) => ({
      mesh,
      instance,
      place: (position: Vector3) => {
        const angle = instance + turn.value;
        position.x += Math.cos(angle);
        position.y += 0.4 * Math.sin(angle);
        position.z += Math.sin(angle);
      },
    })),
    objects: [mesh],
    computes: [compute],
    changes: [
      () => {
        turn.value = 1.9;
        renderer.compute(compute);
      },
    ],
  };
}

function placeOf(i: number): Vector3 {
  const angle = (2 * Math.PI * i) / COUNT;
  return new Vector3(1.2 * Math.cos(angle), 0.2 * i - 0.6, 1.2 * Math.sin(angle));
}

/** As its types do not tell of a matrix in a buffer. */
interface Matrix {
  element(column: number): Node<'vec4'>;
}

/** Instance matrices that a compute shader writes, after bounds were found of the processor's. */
function computedMatrices(renderer: WebGPURenderer): NodeKind {
  const material = new MeshLambertNodeMaterial();
  const mesh = new InstancedMesh(new BoxGeometry(0.4, 0.3, 0.5), material, COUNT);
  const matrices = Array.from({ length: COUNT }, (_, i) =>
    new Matrix4().compose(
      placeOf(i),
      new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), i),
      new Vector3(1, 1 + 0.1 * i, 1),
    ),
  );
  const attribute = new StorageInstancedBufferAttribute(COUNT, 16);
  matrices.forEach((matrix, i) => matrix.toArray(attribute.array, 16 * i));
  mesh.instanceMatrix = attribute;
  mesh.frustumCulled = false;
  const stored = storage(attribute, 'mat4', COUNT);
  const lift = uniform(0);
  const compute = Fn(() => {
    const column = (stored.element(instanceIndex) as unknown as Matrix).element(3);
    column.y.addAssign(lift);
  })().compute(COUNT) as ComputeNode;
  return {
    materials: [material],
    surfaces: matrices.map((matrix, instance) => ({
      mesh,
      instance,
      place: (position) => void position.applyMatrix4(matrix),
    })),
    objects: [mesh],
    computes: [compute],
    changes: [
      () => {
        lift.value = 0.3;
        renderer.compute(compute);
        for (const matrix of matrices) matrix.elements[13]! += 0.3;
      },
    ],
  };
}

/** The positions themselves are written by a compute shader: the processor's are of before. */
function computedVertices(renderer: WebGPURenderer): NodeKind {
  const geometry = plane(8);
  const flat = geometry.attributes.position!;
  const { count } = flat;
  const written = new StorageBufferAttribute(new Float32Array(flat.array), 3);
  const base = new StorageBufferAttribute(new Float32Array(flat.array), 3);
  geometry.setAttribute('position', written);
  const time = uniform(0.3);
  const to = storage(written, 'vec3', count);
  const from = storage(base, 'vec3', count);
  const compute = Fn(() => {
    const place = from.element(instanceIndex).toVar();
    const height = place.x.mul(6).add(time).sin().mul(0.15);
    to.element(instanceIndex).assign(vec3(place.x, place.y, place.z.add(height)));
  })().compute(count) as ComputeNode;
  renderer.compute(compute);
  const material = new MeshStandardNodeMaterial();
  const meshes = put(geometry, material);
  const still = new PlaneGeometry(1.4, 1.4, 8, 8).attributes.position!;
  return {
    materials: [material],
    surfaces: surfacesOf(meshes, {
      place: (position, i) => {
        position.fromBufferAttribute(still, i);
        wave(() => time.value)(position, i);
      },
    }),
    computes: [compute],
    changes: [
      () => {
        time.value = 2.1;
        renderer.compute(compute);
      },
    ],
  };
}

/** Groups within groups, each with planes. */
function clipped(): NodeKind {
  const plain = new MeshBasicMaterial();
  const cut = new MeshStandardNodeMaterial();
  cut.maskNode = gap().not();
  const planes = [
    new Plane(new Vector3(0.3, 0.9, -0.2).normalize(), 0.3),
    new Plane(new Vector3(-0.5, -0.6, 0.6).normalize(), 0.6),
    new Plane(new Vector3(0, 1, 0), 0.7),
  ];
  const inner = new ClippingGroup();
  inner.clippingPlanes = [planes[0]!, planes[1]!];
  inner.clipIntersection = true;
  const outer = new ClippingGroup();
  outer.clippingPlanes = [planes[2]!];
  const meshes = put(plane(1), [plain, cut, cut, plain]);
  // One in neither, one in the outer only, two in both.
  const deep = new Object3D();
  outer.add(meshes[1]!, inner);
  inner.add(deep, meshes[2]!);
  deep.add(meshes[3]!);
  const above = (i: number, { point }: Hit) => planes[i]!.distanceToPoint(point) >= 0;
  const rules: There[] = [
    () => true,
    (hit) => !outer.enabled || above(2, hit),
    ...Array.from({ length: 2 }, (): There => (hit) => {
      const inside = [above(0, hit), above(1, hit)];
      return (
        (!outer.enabled || above(2, hit)) &&
        (!inner.enabled ||
          (inner.clipIntersection ? inside.includes(true) : !inside.includes(false)))
      );
    }),
  ];
  return {
    materials: [plain, cut],
    surfaces: meshes.map((mesh, i) => ({
      mesh,
      there: (hit) => rules[i]!(hit) && (mesh.material !== cut || stripes(hit)),
    })),
    objects: [meshes[0]!, outer],
    changes: [
      () => planes[2]!.translate(new Vector3(0, -0.2, 0)),
      () => (inner.clipIntersection = false),
      () => (outer.enabled = false),
      () => (inner.enabled = false),
    ],
  };
}

/** One mesh, four materials, each its own group of triangles: one moves, one is cut, one is not there. */
function grouped(): NodeKind {
  const time = uniform(0.4);
  const moving = new MeshStandardNodeMaterial({ side: BackSide });
  moving.positionNode = waved(time);
  const cut = new MeshBasicNodeMaterial({ side: DoubleSide });
  cut.maskNode = gap().not();
  const plain = new MeshStandardNodeMaterial();
  const glass = new MeshBasicNodeMaterial({ transparent: true, opacity: 0.3 });
  const geometry = plane(4);
  const { count } = geometry.index!;
  for (let i = 0; i < 4; i++) geometry.addGroup((i * count) / 4, count / 4, i);
  const meshes = put(geometry, plain);
  const materials: Material[] = [plain, moving, cut, glass];
  for (const mesh of meshes) Object.assign(mesh, { material: materials });
  const quarter = (i: number) => {
    const part = geometry.clone();
    part.clearGroups();
    part.setIndex(Array.from(geometry.index!.array).slice((i * count) / 4, ((i + 1) * count) / 4));
    return part;
  };
  const parts = [quarter(0), quarter(1), quarter(2)];
  const there: (There | undefined)[] = [undefined, undefined, stripes];
  return {
    materials,
    surfaces: meshes.flatMap((mesh) =>
      parts.map((part, i) => ({
        mesh,
        geometry: part,
        there: there[i],
        place: i === 1 ? wave(() => time.value) : undefined,
      })),
    ),
    objects: meshes,
    changes: [() => (time.value = 1.3), () => (plain.side = BackSide)],
  };
}

/** Its bounds are those of another size. */
function scaled(): NodeKind {
  const radius = uniform(0.5);
  const material = new MeshBasicNodeMaterial();
  material.positionNode = positionLocal.mul(radius);
  const meshes = put(new SphereGeometry(1, 24, 16), material);
  return {
    materials: [material],
    surfaces: surfacesOf(meshes, {
      place: (position) => void position.multiplyScalar(radius.value),
    }),
    changes: [() => (radius.value = 0.35)],
  };
}

/** None of them moves or cuts anything. */
function plainMaterials(): NodeKind {
  const named = new MeshPhysicalNodeMaterial({
    name: 'red',
    roughness: 0.2,
    map: waves(4, 0).texture,
  });
  const lit = new MeshStandardNodeMaterial({ color: 0x448822, opacity: 0.5 });
  lit.emissiveNode = vec3(uv(), 0);
  lit.normalNode = vec3(0, 0, 1);
  const materials = [named, lit, new MeshLambertNodeMaterial(), new MeshNormalMaterial()];
  return {
    materials,
    surfaces: surfacesOf(put(plane(2), materials), {}),
    changes: [
      () => {
        lit.roughness = 0.1;
        lit.side = BackSide;
        lit.needsUpdate = true;
      },
    ],
  };
}

/** Placed by the world matrix of its own, in the nodes. */
function worldPlaced(): NodeKind {
  const material = new MeshBasicNodeMaterial({ side: FrontSide });
  material.vertexNode = cameraProjectionMatrix
    .mul(cameraViewMatrix)
    .mul(modelWorldMatrix)
    .mul(vec4(positionGeometry.mul(0.8), 1));
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(2), material), {
      place: (position) => void position.multiplyScalar(0.8),
    }),
    changes: [],
  };
}

const classic = (name: keyof typeof materialKinds): MakeNodeKind =>
  materialKinds[name] as unknown as MakeNodeKind;

export const nodeKinds = {
  positionNode: moved,
  'positionNode, by the world’s place and a time told each draw': blown,
  'positionNode that scales': scaled,
  vertexNode: projected,
  'vertexNode of positionView': projectedFromView,
  'vertexNode, placed in the world': worldPlaced,
  maskNode: masked,
  'alphaTestNode and opacityNode': alphaTested,
  'colorNode that discards': colorDiscards,
  'outputNode that discards': outputDiscards,
  'fragmentNode that discards': fragmentDiscards,
  mrtNode: mrtAlone,
  'displacement map of a node material': displaced,
  'classic displacement map': classic('displacement'),
  'classic alpha test': classic('alpha test'),
  'classic alpha map': alphaMapped,
  'classic alpha to coverage': classic('alpha to coverage'),
  'classic vertex alpha': classic('vertex alpha'),
  'Mesh.count and a storage buffer': counted,
  'Mesh.count and an instancedArray': computedInstances,
  'instance matrices that are computed': computedMatrices,
  'vertices that are computed': computedVertices,
  ClippingGroup: clipped,
  'several materials': grouped,
  'plain materials': plainMaterials,
} satisfies Record<string, MakeNodeKind>;

export type NodeKindName = keyof typeof nodeKinds;
