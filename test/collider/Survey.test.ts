import {
  BatchedMesh,
  BoxGeometry,
  BufferGeometry,
  Group,
  InstancedMesh,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Layers,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Object3D,
  Scene,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { DrawnObjects } from '../../src/collider/DrawnObjects.js';
import type { SelectionRules } from '../../src/collider/SceneWalk.js';
import { Selection } from '../../src/collider/Selection.js';
import { Survey } from '../../src/collider/Survey.js';
import { SurfaceField } from '../../src/field/SurfaceField.js';
import { box, skinned } from '../support/meshes.js';

const origin = new Vector3();
const FAR = 2;

/** A survey after one draw of a scene. */
function drawn(...objects: Object3D[]) {
  const scene = new Scene().add(...objects);
  const rules = {
    layers: new Layers(),
    filter: null as SelectionRules['filter'],
    excluded: new Set<Object3D>(),
  };
  const selection = new Selection();
  const survey = new Survey();
  const draw = () => {
    selection.select(scene, origin, FAR, rules, (source) => source);
    survey.note(selection.proxies, origin, FAR);
  };
  draw();
  return {
    scene,
    rules,
    survey,
    draw,
    /** What the survey says now: the names of what is true. */
    look(): string {
      const { moved, changed, deforms } = survey.look(scene, origin, 0, rules);
      return Object.entries({ moved, changed, deforms })
        .filter(([, is]) => is)
        .map(([name]) => name)
        .join(' ');
    },
  };
}

describe('a survey', () => {
  it('should find nothing where nothing happened, though much happens out of reach', () => {
    const far = box();
    far.position.x = 10;
    const { look, scene } = drawn(box(), far);
    expect(look()).toBe('');
    far.position.x = 8;
    far.geometry.attributes.position!.needsUpdate = true;
    scene.add(new Object3D());
    expect(look()).toBe('');
  });

  it('should tell what moved, itself or by its parents, until it is drawn there or back', () => {
    const lift = new Group();
    const plate = box();
    lift.add(plate);
    const { look, draw } = drawn(lift);
    lift.position.y = 0.001;
    expect(look()).toBe('moved');
    expect(look()).toBe('moved');
    draw();
    expect(look()).toBe('');
    plate.rotation.y = 1;
    expect(look()).toBe('moved');
    plate.rotation.y = 0;
    expect(look()).toBe('');
  });

  const changes: [string, (mesh: Mesh<BufferGeometry, MeshBasicMaterial>, scene: Scene) => void][] =
    [
      ['came', (_, scene) => scene.add(box())],
      ['came within reach', (_, { children }) => children[1]!.position.set(1, 0, 0)],
      ['went', (mesh) => mesh.removeFromParent()],
      ['went out of reach', (mesh) => mesh.position.setX(9)],
      ['was hidden', (mesh) => (mesh.visible = false)],
      ['was hidden with its parent', (_, scene) => (scene.visible = false)],
      ['changed its layer', (mesh) => mesh.layers.set(5)],
      ['was opted out', (mesh) => (mesh.userData.collider = false)],
      ['became a sensor', (mesh) => (mesh.userData.sensor = true)],
      ['became glass', ({ material }) => (material.transparent = true)],
      ['shows another side', ({ material }) => (material.side = 1)],
      ['has another geometry', (mesh) => (mesh.geometry = new BoxGeometry())],
      ['has other positions', ({ geometry }) => (geometry.attributes.position!.needsUpdate = true)],
      [
        'has another attribute of positions',
        ({ geometry }) => geometry.setAttribute('position', geometry.attributes.normal!),
      ],
      ['has another index', ({ geometry }) => (geometry.index!.needsUpdate = true)],
      ['lost its index', ({ geometry }) => geometry.setIndex(null)],
      ['draws another range', ({ geometry }) => geometry.setDrawRange(0, 6)],
      ['lost its groups', ({ geometry }) => geometry.clearGroups()],
      [
        'was swapped for its like',
        (mesh, scene) => {
          scene.remove(mesh);
          scene.add(box());
        },
      ],
    ];
  it.each(changes)('should tell that something %s, until it is drawn so', (_, change) => {
    const mesh = box() as unknown as Mesh<BufferGeometry, MeshBasicMaterial>;
    const away = box();
    away.position.x = 9;
    const { look, draw, scene } = drawn(mesh, away);
    expect(look()).toBe('');
    change(mesh, scene);
    expect(look()).toContain('changed');
    draw();
    expect(look()).toBe('');
  });

  it('should tell of instances and batches that moved, came, went or hid', () => {
    const material = new MeshBasicMaterial();
    const forest = new InstancedMesh(new BoxGeometry(), material, 3);
    const batch = new BatchedMesh(2, 24, 36, material);
    const member = batch.addInstance(batch.addGeometry(new BoxGeometry()));
    batch.computeBoundingSphere();
    const { look, draw } = drawn(forest, batch);
    const step = (act: () => void) => {
      act();
      const seen = look();
      draw();
      return [seen, look()];
    };
    expect(look()).toBe('');
    expect(step(() => (forest.instanceMatrix.needsUpdate = true))).toEqual(['changed', '']);
    expect(step(() => (forest.count = 2))).toEqual(['changed', '']);
    expect(step(() => batch.setMatrixAt(member, new Matrix4()))).toEqual(['changed', '']);
    const hide = () => {
      batch.setVisibleAt(member, false);
      // As three's next render leaves it.
      (batch as unknown as { _visibilityChanged: boolean })._visibilityChanged = false;
    };
    expect(step(hide)).toEqual(['changed', '']);
  });

  it('should tell of one group of many that became solid, and of interleaved positions', () => {
    const glass = new MeshBasicMaterial({ transparent: true });
    const mesh = box(new MeshBasicMaterial(), glass, new MeshBasicMaterial());
    const buffer = new InterleavedBuffer(new Float32Array(18), 6);
    const strip = new BufferGeometry();
    strip.setAttribute('position', new InterleavedBufferAttribute(buffer, 3, 0));
    const { look, draw } = drawn(mesh, new Mesh(strip, glass.clone()));
    glass.transparent = false;
    expect(look()).toBe('changed');
    draw();
    expect(look()).toBe('');
    const other = drawn(new Mesh(strip, new MeshBasicMaterial()));
    buffer.needsUpdate = true;
    expect(other.look()).toBe('changed');
  });

  it('should obey exclusion and the filter as they are now', () => {
    const mesh = box();
    const { look, rules } = drawn(mesh, box());
    rules.filter = (object) => object !== mesh;
    expect(look()).toBe('changed');
    rules.filter = null;
    expect(look()).toBe('');
    rules.excluded.add(mesh);
    expect(look()).toBe('changed');
  });

  it('should say that something may deform, as long as it is solid and within reach', () => {
    const skin = skinned();
    const { look } = drawn(skin, box());
    expect(look()).toBe('deforms');
    skin.position.x = 9;
    expect(look()).toBe('changed');
  });

  it('should list the sensors within reach, which are not drawn', () => {
    const coin = box();
    const zone = box(new MeshBasicMaterial({ visible: false }));
    const far = box();
    const hidden = box();
    const group = new Group();
    for (const object of [coin, zone, far, hidden, group]) object.userData.sensor = true;
    far.position.x = 9;
    hidden.visible = false;
    const below = box();
    coin.add(below);
    const { look, survey, rules, draw } = drawn(coin, zone, far, hidden, group);
    rules.filter = (object) => object !== coin;
    expect(look()).toBe('');
    expect(survey.report.sensors).toEqual([coin, zone]);
    coin.position.x = 0.5;
    // What hangs below a sensor is as solid as anything.
    expect(look()).toBe('moved');
    draw();
    coin.position.x = 9;
    expect(look()).toBe('changed');
    expect(survey.report.sensors).toEqual([zone]);
  });

  // Whether a number is kept in an object of its own is the compiler's luck, and lasts: another start decides anew. What
  // makes objects makes them at every start.
  it('should make no object, however often', { retry: 4 }, async () => {
    const objects = Array.from({ length: 50 }, (_, i) => {
      const object = box();
      object.userData.sensor = i % 10 === 0;
      return object;
    });
    const { scene, survey, rules, draw } = drawn(...objects);
    const table = new DrawnObjects();
    const field = new SurfaceField(4, FAR);
    const selection = new Selection();
    selection.select(scene, origin, FAR, rules, (source) => source);
    const round = () => {
      draw();
      survey.look(scene, origin, FAR, rules);
      table.take(selection.proxies);
      table.handTo(field);
    };
    // three's own matrices, 51 of them, box their numbers until they are compiled.
    for (let i = 0; i < 3000; i++) round();
    let least = Infinity;
    // When the compiler is done depends on what else the machine does: what goes on making objects never gets there.
    for (let trial = 0; trial < 60 && least >= 512; trial++) {
      const before = process.memoryUsage().heapUsed;
      for (let i = 0; i < 200; i++) round();
      const grown = process.memoryUsage().heapUsed - before;
      if (grown >= 0) least = Math.min(least, grown / 200);
      // It works beside us, if there is a processor left.
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    expect(least).toBeLessThan(512);
  });
});
