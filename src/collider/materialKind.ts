import { BackSide, DoubleSide, Material, type Side, type Texture } from 'three';

/**
 * How a material is drawn into the cubemap.
 *
 * - `plain`: it changes neither shape nor coverage, and shares one program with all others like it.
 * - `cut`: three's own displacement, alpha or clipping planes; drawn by our program with three's parts for them.
 * - `shader`: the user's code may do anything; it is run, and only what it puts out is ours.
 * - `foreign`: made for another renderer; only its vertices are known.
 */
export type MaterialKind = 'plain' | 'cut' | 'shader' | 'foreign';

interface AnyMaterial extends Material {
  isShaderMaterial?: boolean;
  isNodeMaterial?: boolean;
  displacementMap?: Texture | null;
  /** Of node materials: what puts their vertices elsewhere. */
  positionNode?: unknown;
  vertexNode?: unknown;
  geometryNode?: unknown;
}

export function materialKind(material: AnyMaterial): MaterialKind {
  if (material.isNodeMaterial === true) return 'foreign';
  if (material.isShaderMaterial === true || isHooked(material)) return 'shader';
  if (!!material.displacementMap || alphaCut(material) > 0) return 'cut';
  return material.clippingPlanes !== null && material.clippingPlanes.length > 0 ? 'cut' : 'plain';
}

/** May its vertices be drawn elsewhere than their attributes say, and unseen by the processor? */
export function movesVertices(material: AnyMaterial): boolean {
  if (material.isShaderMaterial === true || !!material.displacementMap) return true;
  // Hooks into GLSL mean nothing to the renderer for node materials.
  if (material.isNodeMaterial !== true) return isHooked(material);
  return !!material.positionNode || !!material.vertexNode || !!material.geometryNode;
}

/** Has the user put code of their own into three's? */
export function isHooked(material: Material): boolean {
  return material.onBeforeCompile !== Material.prototype.onBeforeCompile;
}

/**
 * Alpha below which nothing is there; 0 where alpha does not matter. What is dithered by its alpha (coverage of a
 * multisampled target, noise) is there from half on.
 */
export function alphaCut({ alphaTest, alphaHash, alphaToCoverage }: Material): number {
  if (alphaTest > 0) return alphaTest;
  return alphaHash || alphaToCoverage ? 0.5 : 0;
}

/**
 * What tells fronts from backs: 1; -1 of what shows the inside of its triangles (culled so, three turns the facing round
 * itself); 0 of what shows both sides, which has fronts alone: no body is inside of a curtain.
 */
export function frontSignOf(side: Side, sides: 'both' | 'drawn'): number {
  if (side === DoubleSide) return 0;
  return sides === 'both' && side === BackSide ? -1 : 1;
}
