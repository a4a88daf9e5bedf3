import {
  Bone,
  Box3,
  BoxGeometry,
  type BufferGeometry,
  Group,
  Layers,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Object3D,
  PerspectiveCamera,
  Scene,
  Skeleton,
  SkinnedMesh,
  Sphere,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { seeded } from '../../e2e/support/axisScenes.js';
import { SceneIndex } from '../../src/collider/SceneIndex.js';
import { Selection } from '../../src/collider/Selection.js';
import { Survey } from '../../src/collider/Survey.js';
import { box, skinned } from '../support/meshes.js';

const FAR = 2;
const MESHES = 10_000;
const { geometry, material } = box();

/** Meshes on a grid of 4 m, in groups of a hundred; one of them where the collider looks from. */
function city(grouped = true) {
  const scene = new Scene();
  const meshes: Mesh<BufferGeometry, Material | Material[]>[] = [];
  for (let i = 0; i < MESHES; i++) {
    const mesh = new Mesh<BufferGeometry, Material | Material[]>(geometry, material);
    mesh.position.set(4 * (i % 100), 0, 4 * Math.floor(i / 100));
    const parent = grouped ? (scene.children[Math.floor(i / 100)] ?? new Group()) : scene;
    if (grouped && parent.parent === null) scene.add(parent);
    parent.add(mesh);
    meshes.push(mesh);
  }
  return { scene, meshes };
}

/** A collider's selection and survey of a scene, as a character uses them. */
function watcher(scene: Object3D, center = new Vector3()) {
  const index = new SceneIndex();
  const selection = new Selection(index);
  const survey = new Survey(index);
  const rules = { layers: new Layers(), filter: null, excluded: new Set<Object3D>() };
  return {
    center,
    index,
    rules,
    select: () => {
      selection.select(scene, center, FAR, rules, (source) => source);
      survey.note(selection.proxies, center, FAR);
      return selection.proxies.map(({ source }) => source);
    },
    look: () => survey.look(scene, center, FAR, rules),
  };
}

/** A unit cube that follows one bone. */
function weighted(bone: Bone): SkinnedMesh {
  const skin = new SkinnedMesh(skinned().geometry, new MeshBasicMaterial());
  const weights = skin.geometry.attributes.skinWeight!.clone();
  for (let i = 0; i < weights.count; i++) weights.setX(i, 1);
  skin.geometry.setAttribute('skinWeight', weights);
  skin.bind(new Skeleton([bone], [new Matrix4()]), new Matrix4());
  return skin;
}

/** Counts who is asked for anything that changes when an object moves, hides or gets children. */
function count(objects: readonly Object3D[]) {
  const touched = new Set<Object3D>();
  for (const object of objects) {
    const { visible, children, position } = object;
    const watch = <T>(name: string, value: T) => {
      Object.defineProperty(object, name, {
        configurable: true,
        get: () => (touched.add(object), value),
      });
    };
    watch('visible', visible);
    watch('children', children);
    watch('position', position);
  }
  return touched;
}

describe('a scene of ten thousand meshes', () => {
  for (const grouped of [true, false]) {
    it(`should be touched in eighths and near by alone, ${grouped ? 'grouped' : 'flat'}`, () => {
      const { scene, meshes } = city(grouped);
      const { select, look, index } = watcher(scene);
      expect(select()).toEqual([meshes[0]]);
      expect(index.near.length).toBeLessThan(10);
      const touched = count(meshes);
      const all = new Set<Object3D>();
      for (let frame = 0; frame < 8; frame++) {
        look();
        // The survey has done this frame's part of what is far.
        select();
        for (const mesh of touched) all.add(mesh);
        expect(touched.size).toBeLessThan(MESHES / 8 + 200);
        touched.clear();
      }
      expect(all.size).toBe(MESHES);
      // A collider without a survey goes on as well.
      for (let frame = 0; frame < 8; frame++) {
        select();
        expect(touched.size).toBeGreaterThan(MESHES / 8 - 200);
        touched.clear();
      }
    });
  }

  it('should have only the matrices of what is near and of an eighth refreshed', () => {
    const { scene, meshes } = city();
    const { select, look } = watcher(scene);
    select();
    for (const mesh of meshes) mesh.position.y = 1;
    look();
    const fresh = meshes.filter(({ matrixWorld }) => matrixWorld.elements[13] === 1).length;
    expect(fresh).toBeGreaterThan(MESHES / 8 - 200);
    expect(fresh).toBeLessThan(MESHES / 8 + 200);
    expect(meshes[0]!.matrixWorld.elements[13]).toBe(1);
  });

  const within = (name: string, act: (city: { scene: Scene; meshes: Mesh[] }) => void) => {
    it(`should show at once, within reach, that something ${name}`, () => {
      const { scene, meshes } = city();
      const { select, look } = watcher(scene);
      const before = select();
      for (let frame = 0; frame < 3; frame++) expect(look().changed).toBe(false);
      act({ scene, meshes });
      const { moved, changed } = look();
      expect(moved || changed).toBe(true);
      const after = select();
      if (!moved) expect(after).not.toEqual(before);
      expect(look().moved || look().changed).toBe(false);
      for (const mesh of after) {
        const { x, y, z } = mesh.position;
        expect(mesh.matrixWorld.elements.slice(12, 15)).toEqual([x, y, z]);
      }
    });
  };
  within('moved', ({ meshes }) => meshes[0]!.position.setY(0.5));
  within('was removed', ({ meshes }) => meshes[0]!.removeFromParent());
  within('was hidden', ({ meshes }) => (meshes[0]!.visible = false));
  within('was hidden with its group', ({ scene }) => (scene.children[0]!.visible = false));
  within('was removed with its group', ({ scene }) => scene.remove(scene.children[0]!));
  within('was added to the scene', ({ scene }) => scene.add(box()));
  within('was added to a group far away', ({ scene }) => scene.children[99]!.add(box()));
  within('was added with a tree of groups', ({ scene }) =>
    scene.add(new Group().add(new Group().add(box()))),
  );
  within('was added to what had none', ({ meshes }) => meshes[0]!.add(box()));
  within('went in the same frame as another came', ({ scene, meshes }) => {
    scene.children[0]!.remove(meshes[0]!);
    scene.children[0]!.add(box());
  });
  within('came near from just out of reach', ({ meshes }) => meshes[1]!.position.setX(2));

  it('should notice within eight frames what comes from far, and what goes there again', () => {
    const { scene, meshes } = city();
    const { select, look } = watcher(scene);
    select();
    const until = (act: () => void) => {
      act();
      for (let frame = 1; frame <= 8; frame++) if (look().changed) return frame;
      return Infinity;
    };
    const traveller = meshes[7777]!;
    const home = traveller.position.x;
    expect(until(() => traveller.position.set(1, 0, 0))).toBeLessThanOrEqual(8);
    expect(select()).toEqual([meshes[0], traveller]);
    expect(until(() => traveller.position.setX(home))).toBe(1);
    expect(select()).toEqual([meshes[0]]);
    expect(until(() => traveller.parent!.position.setX(1 - home))).toBeLessThanOrEqual(8);
    expect(select()).toContain(traveller);
  });

  it('should select, wherever the collider goes, what a walk over all would (seed 11)', () => {
    const random = seeded(11);
    const { scene, meshes } = city();
    const { select, look, center } = watcher(scene);
    const apart = new Vector3();
    for (let i = 0; i < 300; i++) {
      // Steps of a walk, and now and then a jump across the city.
      if (i % 10 === 0) center.set(400 * random(), 2 * random() - 1, 400 * random());
      else center.add(new Vector3(random() - 0.5, 0, random() - 0.5).multiplyScalar(3));
      const radius = geometry.boundingSphere!.radius + FAR;
      const expected = meshes.filter(({ position }) => {
        const { x, y, z } = apart.subVectors(position, center);
        const most = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
        return most <= 0.5 + FAR && apart.length() <= radius;
      });
      expect(select(), `${center.toArray()}`).toEqual(expected);
      look();
    }
  });
});

describe('what is far', () => {
  /** Meshes of their own geometries, in groups in groups; one object in ten sees to its matrices in a way of its own. */
  function hamlet(random: () => number) {
    class Shifted extends Group {
      shift = 0;
      override updateMatrix(): void {
        super.updateMatrix();
        this.matrix.elements[12]! += this.shift;
      }
    }
    const scene = new Scene();
    const groups: Group[] = [];
    const meshes: Mesh[] = [];
    for (let i = 0; i < 40; i++) {
      const group = i % 10 === 3 ? new Shifted() : new Group();
      (i < 20 ? scene : groups[i - 20]!).add(group);
      groups.push(group);
    }
    for (let i = 0; i < 800; i++) {
      const mesh = new Mesh(new BoxGeometry(), material);
      mesh.position.set(80 * random() - 40, 2 * random(), 80 * random() - 40);
      groups[i % groups.length]!.add(mesh);
      meshes.push(mesh);
    }
    return { scene, groups, meshes };
  }

  it('should be known within eight frames, however it changed (seed 23)', () => {
    const random = seeded(23);
    const { scene, groups, meshes } = hamlet(random);
    const { select, look, center } = watcher(scene);
    const any = <T>(list: readonly T[]) => list[Math.floor(random() * list.length)]!;
    // Farther than what is watched around the collider.
    const far = () => (random() < 0.5 ? -1 : 1) * (8 + 20 * random());
    const changes: ((object: Object3D, mesh: Mesh) => void)[] = [
      ({ position }) => (position.z = far()),
      ({ rotation }) => (rotation.y += 1 + random()),
      ({ scale }) => scale.setScalar(0.5 + random()),
      (_, { position }) => position.set(far(), 1, far()),
      (_, mesh) => any(groups).add(mesh),
      (_, mesh) => mesh.geometry.translate(0, 0, far()),
      (_, mesh) => mesh.geometry.scale(1.5, 1, 1).computeBoundingSphere(),
      (_, mesh) => (mesh.geometry = new BoxGeometry(1 + 4 * random(), 1, 1).translate(far(), 0, 0)),
      (_, mesh) => (mesh.frustumCulled = !mesh.frustumCulled),
      (object) => (object.matrixAutoUpdate = !object.matrixAutoUpdate),
      (object) => (object.matrixWorldAutoUpdate = true),
      (_, mesh) => {
        mesh.matrixWorldAutoUpdate = false;
        mesh.matrixWorld.setPosition(far(), 1, far());
      },
      (object) => {
        object.matrix.elements[12] = far();
        object.matrixWorldNeedsUpdate = true;
      },
      (object) => {
        object.pivot = new Vector3(far(), 0, far());
        object.rotation.y += 1;
      },
      ({ pivot }) => pivot?.setX(far()),
      () => ((groups[3] as Group & { shift: number }).shift = far()),
      // A render of the user's own comes in between.
      () => scene.updateMatrixWorld(),
      () => center.set(far(), 1, far()),
    ];
    const sphere = new Sphere();
    const cube = new Box3();
    const bounds = new Box3();
    const point = new Vector3();
    /** Is a part of a box, as it stands, surely in the cube that the faces see? */
    const isIn = ({ geometry, matrixWorld }: Mesh) => {
      geometry.computeBoundingBox();
      const { min, max } = geometry.boundingBox!;
      for (let i = 0; i < 125; i++) {
        const at = [i % 5, Math.floor(i / 5) % 5, Math.floor(i / 25)].map((k) => k / 4);
        point.set(...(at as [number, number, number])).multiply(bounds.min.subVectors(max, min));
        if (cube.containsPoint(point.add(min).applyMatrix4(matrixWorld))) return true;
      }
      return false;
    };
    /** May one be? */
    const mayBeIn = ({ geometry, matrixWorld }: Mesh) => {
      geometry.computeBoundingBox();
      return bounds.copy(geometry.boundingBox!).applyMatrix4(matrixWorld).intersectsBox(cube);
    };
    let seen = 0;
    for (let i = 0; i < 150; i++) {
      for (let j = 0; j < 20; j++) {
        const mesh = any(meshes);
        any(changes)(random() < 0.1 ? any(groups) : mesh, mesh);
        if (random() < 0.3) look();
      }
      for (let frame = 0; frame < 8; frame++) look();
      for (let place = 0; place < 6; place++) {
        const found = new Set(select());
        // three's own word, where it stands after that.
        if (place === 0) scene.updateMatrixWorld();
        cube.setFromCenterAndSize(center, point.setScalar(2.01 * FAR));
        const likely = meshes.filter((mesh) => {
          const { frustumCulled, geometry, matrixWorld } = mesh;
          if (place === 0) geometry.computeBoundingSphere();
          sphere.copy(geometry.boundingSphere!).applyMatrix4(matrixWorld);
          const near = sphere.center.distanceTo(center) <= sphere.radius + FAR;
          return !frustumCulled || (near && mayBeIn(mesh));
        });
        for (const mesh of found) expect(likely.includes(mesh as Mesh), `round ${i}`).toBe(true);
        cube.setFromCenterAndSize(center, point.setScalar(2 * FAR));
        const certain = likely.filter((mesh) => !mesh.frustumCulled || isIn(mesh));
        expect(certain.every((mesh) => found.has(mesh))).toBe(true);
        seen += found.size;
        center.set(60 * random() - 30, 1, 60 * random() - 30);
      }
    }
    expect(seen).toBeGreaterThan(3000);
  });

  it('should be found where it was, if it went away while it was near and came back', () => {
    const { scene, meshes } = city();
    const { select, look, center } = watcher(scene);
    const traveller = meshes[7777]!;
    const home = traveller.position.clone();
    for (let frame = 0; frame < 9; frame++) look();
    center.copy(home);
    expect(select()).toContain(traveller);
    traveller.position.x += 100;
    expect(select()).not.toContain(traveller);
    traveller.position.copy(home);
    center.set(200, 0, 0);
    for (let frame = 0; frame < 9; frame++) select();
    center.copy(home);
    expect(select()).toContain(traveller);
  });

  it('should be asked for its pose, and have no matrix worked out while it stands still', () => {
    const { scene, meshes } = city();
    const { select, look } = watcher(scene);
    select();
    for (let frame = 0; frame < 8; frame++) look();
    let composed = 0;
    for (const { matrix } of meshes) {
      const { compose } = matrix;
      matrix.compose = (...args) => (composed++, compose.apply(matrix, args));
    }
    for (let frame = 0; frame < 8; frame++) look();
    expect(composed).toBeLessThan(8 * 10);
    scene.children[99]!.position.x = 1;
    for (let frame = 0; frame < 8; frame++) look();
    expect(composed).toBeLessThan(16 * 10 + 100);
    expect(meshes.at(-1)!.matrixWorld.elements[12]).toBe(4 * 99 + 1);
  });
});

describe('an index', () => {
  it('should let go of what was removed, in any way', () => {
    const { scene, meshes } = city();
    const { select, look, index, rules } = watcher(scene);
    select();
    expect(index.size).toBe(MESHES + 101);
    scene.remove(scene.children[50]!);
    // Past three: it is found in its turn.
    scene.children[20]!.children.splice(30, 5);
    for (let frame = 0; frame < 8; frame++) look();
    expect(index.size).toBe(MESHES + 101 - 101 - 5);
    scene.clear();
    look();
    expect(index.size).toBe(1);
    expect(index.near).toEqual([]);
    scene.add(meshes[3]!);
    look();
    expect(index.size).toBe(2);
    index.clear();
    expect(index.size).toBe(0);
    // Another scene takes the place of the first.
    index.update(new Scene().add(box()), new Vector3(), FAR, true);
    expect(index.size).toBe(2);
    expect(rules.excluded.size).toBe(0);
  });

  it('should take tiles that come and go every frame in and out at once, and keep none', () => {
    const { scene } = city();
    const tiles = new Group();
    scene.add(tiles);
    const { select, look, index } = watcher(scene);
    const [first] = select();
    const before = index.size;
    for (let frame = 0; frame < 200; frame++) {
      const near = box();
      const away = box();
      away.position.x = 50;
      tiles.add(new Group().add(near), new Group().add(away));
      if (tiles.children.length > 6) tiles.remove(tiles.children[0]!, tiles.children[1]!);
      expect(look().changed).toBe(true);
      const seen = select();
      expect(seen).toHaveLength(1 + tiles.children.length / 2);
      expect(seen.at(-1)).toBe(near);
      expect(index.size).toBe(before + 2 * tiles.children.length);
    }
    tiles.clear();
    look();
    expect(index.size).toBe(before);
    expect(select()).toEqual([first]);
    expect(index.near.every(({ object }) => object.parent !== null)).toBe(true);
  });

  it('should follow what is reparented, reordered, inserted and taken back', () => {
    const a = new Group();
    const b = new Group();
    const [p, q, r] = [box(), box(), box()];
    const scene = new Scene().add(a, b);
    a.add(p, q, r);
    const { select, index } = watcher(scene);
    expect(select()).toEqual([p, q, r]);
    b.position.x = 9;
    b.add(q);
    expect(select()).toEqual([p, r]);
    a.add(q);
    a.add(p);
    expect(new Set(select())).toEqual(new Set([p, q, r]));
    a.children.reverse();
    a.children.splice(1, 0, box());
    expect(select()).toHaveLength(4);
    q.add(b);
    expect(select()).toHaveLength(4);
    expect(index.size).toBe(7);
  });

  it('should bring world matrices up to date as a render does, and leave the rest to it', () => {
    const group = new Group();
    const still = box();
    const sibling = box();
    sibling.position.x = 50;
    const scene = new Scene().add(group);
    group.add(still, sibling);
    scene.updateMatrixWorld();
    for (const object of [group, still, sibling]) object.matrixAutoUpdate = false;
    const { select, look } = watcher(scene);
    select();
    // Not told of: three would not follow either.
    still.position.y = 7;
    look();
    expect(still.matrixWorld.elements[13]).toBe(0);
    group.matrix.makeTranslation(0, 1, 0);
    group.matrixWorldNeedsUpdate = true;
    expect(look().moved).toBe(true);
    expect(still.matrixWorld.elements[13]).toBe(1);
    select();
    scene.updateMatrixWorld();
    expect(sibling.matrixWorld.elements.slice(12, 15)).toEqual([50, 1, 0]);

    still.matrixWorldAutoUpdate = false;
    still.matrixWorld.makeTranslation(0, 0.25, 0);
    look();
    expect(still.matrixWorld.elements[13]).toBe(0.25);
    scene.matrixWorldAutoUpdate = false;
    group.matrix.makeTranslation(0, 2, 0);
    group.matrixWorldNeedsUpdate = true;
    still.matrixWorldAutoUpdate = true;
    look();
    expect(still.matrixWorld.elements[13]).toBe(0.25);
  });

  it('should let objects with a way of their own see to what is below them', () => {
    class Frozen extends Group {
      override updateMatrixWorld(): void {}
    }
    const frozen = new Frozen();
    const inside = box();
    frozen.add(inside);
    const hung = box();
    const camera = new PerspectiveCamera();
    camera.add(hung);
    const { select } = watcher(new Scene().add(frozen, camera));
    inside.position.y = camera.position.y = 0.5;
    select();
    expect(inside.matrixWorld.elements[13]).toBe(0);
    expect(hung.matrixWorld.elements[13]).toBe(0.5);
  });

  it('should refresh the bones of skins that are near, and of no others', () => {
    const soldier = (x: number) => {
      const root = new Group();
      const bone = new Bone();
      const skin = weighted(bone);
      // As glTF has it: bones beside the skin, and those of many after it.
      root.add(skin, new Group().add(bone));
      root.position.x = x;
      return { root, bone, skin };
    };
    const near = soldier(0);
    const away = soldier(100);
    const scene = new Scene().add(near.root, away.root);
    const { select, look } = watcher(scene);
    select();
    near.bone.position.y = away.bone.position.y = 0.5;
    near.skin.position.y = 0.25;
    expect(look().deforms).toBe(true);
    expect(near.bone.matrixWorld.elements[13]).toBe(0.5);
    expect(away.bone.matrixWorld.elements[13]).toBe(0);
    expect(near.skin.bindMatrixInverse.elements[13]).toBe(-0.25);
  });

  it('should find the bounds of a skin with its bones in place', () => {
    const bone = new Bone();
    bone.position.x = 20;
    const skin = weighted(bone);
    const { select } = watcher(new Scene().add(skin, new Group().add(bone)), new Vector3(20, 0, 0));
    expect(select()).toEqual([skin]);
  });

  it('should not look at the vertices of what is hidden, and see it at once when it shows', () => {
    const statue = box();
    const { position } = statue.geometry.attributes;
    Object.defineProperty(position, 'count', { value: 5000 });
    statue.visible = false;
    statue.geometry.boundingSphere = null;
    const { select } = watcher(new Scene().add(statue));
    expect(select()).toEqual([]);
    expect(statue.geometry.boundingSphere).toBeNull();
    Object.defineProperty(position, 'count', { value: 24 });
    statue.visible = true;
    expect(select()).toEqual([statue]);
  });
});
