import type { BatchedMesh, InstancedMesh, Mesh, SkinnedMesh, Sphere } from 'three';
import { PartsSphere } from './PartsSphere.js';
import { SkinSphere } from './SkinSphere.js';

/** Vertices whose bounding sphere is found in no time. */
const FEW = 4096;

const parts = /* @__PURE__ */ new WeakMap<Mesh, PartsSphere>();
const skins = /* @__PURE__ */ new WeakMap<Mesh, SkinSphere>();

/**
 * A sphere around all that a mesh shows now, world space: three's own, where it can be trusted. three computes those of
 * instances, batches and skins once, and again only if told to; theirs are ours, and the user's are left alone.
 *
 * @returns whether there is one; if not, nobody knows where the mesh ends
 */
export function worldSphere(mesh: Mesh, target: Sphere): boolean {
  try {
    if ((mesh as SkinnedMesh).isSkinnedMesh) {
      let skin = skins.get(mesh);
      if (skin === undefined) skins.set(mesh, (skin = new SkinSphere()));
      skin.find(mesh as SkinnedMesh, target);
    } else if (hasParts(mesh)) {
      let sphere = parts.get(mesh);
      if (sphere === undefined) parts.set(mesh, (sphere = new PartsSphere()));
      target.copy(sphere.of(mesh)).applyMatrix4(mesh.matrixWorld);
    } else {
      const { geometry } = mesh;
      if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
      target.copy(geometry.boundingSphere!).applyMatrix4(mesh.matrixWorld);
    }
  } catch {
    // Positions that were uploaded and thrown away, for one.
    return false;
  }
  return !Number.isNaN(target.radius + target.center.x + target.center.y + target.center.z);
}

/** Is that sphere there already? Where it is not, it costs all the vertices to find. */
export function hasSphere(mesh: Mesh): boolean {
  if ((mesh as SkinnedMesh).isSkinnedMesh) return skins.has(mesh);
  return hasParts(mesh) ? parts.has(mesh) : mesh.geometry.boundingSphere !== null;
}

/** Or is it found in no time? Those of skins, instances and batches are not. */
export function isCheap(mesh: Mesh): boolean {
  if ((mesh as SkinnedMesh).isSkinnedMesh || hasParts(mesh)) return false;
  return !(mesh.geometry.attributes.position!.count > FEW);
}

/** Does it follow from the world matrix and the geometry's own sphere, which is there, and from nothing else? */
export function followsGeometry(mesh: Mesh): boolean {
  return (
    mesh.isMesh &&
    mesh.frustumCulled &&
    !(mesh as SkinnedMesh).isSkinnedMesh &&
    !hasParts(mesh) &&
    !!mesh.geometry?.boundingSphere
  );
}

function hasParts(mesh: Mesh): mesh is InstancedMesh | BatchedMesh {
  return (
    (mesh as InstancedMesh).isInstancedMesh === true || (mesh as BatchedMesh).isBatchedMesh === true
  );
}
