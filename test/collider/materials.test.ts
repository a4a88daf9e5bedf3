import {
  Material,
  Mesh,
  MeshBasicMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  Plane,
  RawShaderMaterial,
  Scene,
  ShaderMaterial,
  Layers,
  type Object3D,
  Texture,
  Vector3,
  DoubleSide,
  FrontSide,
  NoBlending,
} from 'three';
import { describe, expect, it } from 'vitest';
import { deriveMaterial, isDerived, refreshUniforms } from '../../src/collider/derivedMaterial.js';
import { isRigid } from '../../src/collider/isRigid.js';
import { isSolid, solidityOf } from '../../src/collider/isSolid.js';
import { alphaCut, materialKind } from '../../src/collider/materialKind.js';
import { SeenMesh } from '../../src/collider/SeenMesh.js';
import { Selection } from '../../src/collider/Selection.js';
import { wrapShader } from '../../src/collider/wrapShader.js';
import { box } from '../support/meshes.js';

const hooked = new MeshStandardMaterial();
hooked.onBeforeCompile = () => {};

describe('the kind of a material', () => {
  const map = new Texture();
  const kinds: [string, Material, ReturnType<typeof materialKind>][] = [
    ['a plain one', new MeshStandardMaterial({ map, normalMap: map }), 'plain'],
    ['glass', new MeshPhysicalMaterial({ transmission: 1, opacity: 0.5 }), 'plain'],
    ['one with an empty list of planes', new MeshBasicMaterial({ clippingPlanes: [] }), 'plain'],
    ['an alpha test', new MeshBasicMaterial({ alphaTest: 0.1 }), 'cut'],
    ['alpha to coverage', new MeshBasicMaterial({ alphaToCoverage: true }), 'cut'],
    ['alpha hash', new MeshBasicMaterial({ alphaHash: true }), 'cut'],
    ['a displacement', new MeshStandardMaterial({ displacementMap: map }), 'cut'],
    ['planes', new MeshBasicMaterial({ clippingPlanes: [new Plane()] }), 'cut'],
    ['a hook', hooked, 'shader'],
    ['a shader', new ShaderMaterial(), 'shader'],
    ['a raw shader', new RawShaderMaterial(), 'shader'],
    ['a node material', Object.assign(new Material(), { isNodeMaterial: true }), 'foreign'],
  ];
  it.each(kinds)('should be told of %s', (_, material, kind) => {
    expect(materialKind(material)).toBe(kind);
  });

  it('should cut by the alpha test, and dithered alpha at half', () => {
    expect(alphaCut(new MeshBasicMaterial({ alphaTest: 0.3, alphaHash: true }))).toBe(0.3);
    expect(alphaCut(new MeshBasicMaterial({ alphaToCoverage: true }))).toBe(0.5);
    expect(alphaCut(new MeshBasicMaterial())).toBe(0);
  });
});

describe('what is solid, by policy', () => {
  it('should be what hides, what is shown, or what is marked', () => {
    const glass = new MeshBasicMaterial({ transparent: true });
    const flat = new MeshBasicMaterial({ depthWrite: false });
    const hidden = new MeshBasicMaterial({ visible: false });
    const judged = (material: Material) =>
      (['opaque', 'shown', 'all'] as const).map((solidity) => isSolid(material, solidity));
    expect(judged(glass)).toEqual([false, true, true]);
    expect(judged(flat)).toEqual([false, true, true]);
    expect(judged(hidden)).toEqual([false, false, true]);
    // What an alpha test cuts out, by a number or by a node.
    const tested = new MeshBasicMaterial({ transparent: true, alphaTest: 0.5 });
    expect(judged(tested)).toEqual([true, true, true]);
    expect(judged(Object.assign(glass.clone(), { alphaTestNode: {} }))).toEqual([true, true, true]);
    expect(judged(null as never)).toEqual([false, false, false]);
    const mesh = box(glass);
    expect(solidityOf(mesh)).toBe('opaque');
    expect(solidityOf(mesh, 'solid')).toBe('shown');
    mesh.userData.collider = true;
    expect(solidityOf(mesh)).toBe('all');
  });

  it('should select a marked mesh that is not visible, but nothing below it', () => {
    const wall = box();
    wall.visible = false;
    wall.userData.collider = true;
    wall.add(box());
    const lone = box();
    lone.visible = false;
    const selection = new Selection();
    const rules = { layers: new Layers(), filter: null, excluded: new Set<Object3D>() };
    selection.select(new Scene().add(wall, lone), new Vector3(), 2, rules, (source) => source);
    expect(selection.proxies.map(({ source }) => source)).toEqual([wall]);
    expect(selection.proxies[0]!.visible).toBe(true);
    rules.excluded.add(wall);
    selection.select(new Scene().add(wall), new Vector3(), 2, rules, (source) => source);
    expect(selection.proxies).toEqual([]);
  });

  it('should let a shader count as deforming where its group is solid', () => {
    const mesh = new Mesh(box().geometry, [
      new MeshBasicMaterial(),
      new ShaderMaterial({ transparent: true }),
    ]);
    expect(isRigid(mesh)).toBe(true);
    expect(isRigid(mesh, 'shown')).toBe(false);
  });
});

describe('what is cut out of a mesh', () => {
  const plane = new Plane(new Vector3(0, 1, 0), 0.5);
  const other = new Texture();
  const changes: [string, (material: MeshBasicMaterial) => void][] = [
    ['another alpha test', (material) => (material.alphaTest = 0.51)],
    ['another opacity', (material) => (material.opacity = 0.8)],
    ['another map', (material) => (material.map = other)],
    ['new contents of its map', (material) => (material.map!.needsUpdate = true)],
    ['its map moved', (material) => (material.map!.offset.x = 0.25)],
    ['an alpha map', (material) => (material.alphaMap = other)],
    ['a plane moved', () => (plane.constant = 0.25)],
    ['a plane turned', () => plane.normal.set(0, -1, 0)],
    ['the common part of its planes', (material) => (material.clipIntersection = true)],
    ['no planes', (material) => (material.clippingPlanes = null)],
    ['another side', (material) => (material.side = DoubleSide)],
  ];
  it.each(changes)('should count as changed with %s', (_, change) => {
    plane.set(new Vector3(0, 1, 0), 0.5);
    const material = new MeshBasicMaterial({
      map: new Texture(),
      alphaTest: 0.5,
      clippingPlanes: [plane],
    });
    const mesh = box(material);
    const seen = new SeenMesh();
    seen.take(mesh, 1);
    expect(seen.changed(mesh)).toBe(false);
    change(material);
    expect(seen.changed(mesh)).toBe(true);
  });

  it('should not count where nothing is cut', () => {
    const material = new MeshBasicMaterial({ map: new Texture() });
    const mesh = box(material);
    const seen = new SeenMesh();
    seen.take(mesh, 1);
    material.map!.needsUpdate = true;
    material.opacity = 0.5;
    expect(seen.changed(mesh)).toBe(false);
  });
});

describe('a derived material', () => {
  it('should be the user’s but for how it is drawn, live, and write nothing to it', () => {
    const source = new MeshPhysicalMaterial({
      transmission: 0.5,
      transparent: true,
      alphaTest: 0.1,
    });
    const before = { ...source };
    const both = deriveMaterial(source, 'both', {});
    const drawn = deriveMaterial(source, 'drawn', { alphaTest: 0.7 });
    expect(isDerived(both)).toBe(true);
    expect(isDerived(source)).toBe(false);
    expect(both).toMatchObject({
      side: DoubleSide,
      blending: NoBlending,
      transparent: false,
      transmission: 0,
      alphaTest: 0.1,
    });
    expect(drawn).toMatchObject({ side: FrontSide, alphaTest: 0.7 });
    source.alphaTest = 0.2;
    source.side = DoubleSide;
    expect([both.alphaTest, drawn.side]).toEqual([0.2, DoubleSide]);
    const { id } = both;
    refreshUniforms(both);
    expect(both.id).not.toBe(id);
    expect(both.id).toBeLessThan(-1);
    let heard = 0;
    source.addEventListener('dispose', () => heard++);
    both.dispose();
    expect(heard).toBe(0);
    const { _listeners, ...rest } = source as unknown as Record<string, unknown>;
    expect(_listeners).toBeDefined();
    expect(rest).toEqual({ ...before, _alphaTest: 0.2, side: DoubleSide });
  });
});

describe('a wrapped shader', () => {
  const options = { output: 'surface', format: 'RGBA32F', glsl3: true, raw: true } as const;
  const fragment = (text: string, more = {}) =>
    wrapShader({ vertexShader: '', fragmentShader: text }, { ...options, ...more }).fragmentShader;

  it('should make variables of outputs, and of nothing else', () => {
    const text = fragment(`
      layout(location = 1) out vec3 a, b; // out vec4 c;
      out highp vec4 d[2];
      void f(out vec3 e);
      void f(out vec3 e, inout vec2 g) { e = vec3(1.); }`);
    expect(text).toMatch(/^\s*vec3 a, b;/m);
    expect(text).toMatch(/^\s*highp vec4 d\[2\];/m);
    expect(text).toContain('void f(out vec3 e);');
    expect(text).toContain('void f(out vec3 e, inout vec2 g)');
    expect(text.match(/\bout vec3 a\b/)).toBeNull();
  });

  it('should put extensions first, and leave out those of the old language', () => {
    const text = '#extension GL_OES_standard_derivatives : enable\nvoid main() {}';
    expect(fragment(text).trimStart().startsWith('#extension')).toBe(true);
    expect(fragment(text, { glsl3: false })).not.toContain('#extension');
  });

  it('should take the depth that a shader writes, and write none otherwise', () => {
    expect(fragment('void main() { gl_FragDepth = 0.5; }')).toContain('cc_depth = 0.5;');
    expect(fragment('void main() {}')).not.toContain('gl_FragDepth');
  });
});
