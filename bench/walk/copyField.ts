import { SurfaceField } from '../../src/field/SurfaceField.js';

/** A field that shares nothing with `source` but the directions: `target` if its resolution fits, else a new one. */
export function copyField(source: SurfaceField, target: SurfaceField | null): SurfaceField {
  const copy =
    target?.resolution === source.resolution
      ? target
      : new SurfaceField(source.resolution, source.far, source.direction.slice());
  copy.far = source.far;
  copy.center.copy(source.center);
  copy.time = source.time;
  copy.serial = source.serial;
  // Drawn finer, each field has directions of its own.
  copy.direction.set(source.direction);
  copy.distance.set(source.distance);
  copy.normal.set(source.normal);
  copy.front.set(source.front);
  copy.object.set(source.object);
  copy.instance.set(source.instance);
  copy.clearObjects();
  source.objects.forEach((object, i) => {
    copy.addObject(object, source.rigid[i]);
    copy.matrices[i]!.copy(source.matrices[i]!);
  });
  return copy;
}
