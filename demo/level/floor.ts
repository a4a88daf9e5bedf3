import {
  type Box3,
  CanvasTexture,
  CircleGeometry,
  Mesh,
  MeshStandardMaterial,
  RepeatWrapping,
  SRGBColorSpace,
  Vector3,
} from 'three';

/** How far it reaches beyond what stands on it, metres. */
const BEYOND = 12;

/** A round floor with lines a metre apart, for what has no ground of its own to be walked around. */
export function createFloor(bounds: Box3): Mesh {
  const size = bounds.getSize(new Vector3());
  const middle = bounds.getCenter(new Vector3());
  const radius = Math.hypot(size.x, size.z) / 2 + BEYOND + 0.4 * size.y;
  const geometry = new CircleGeometry(radius, 64).rotateX(-Math.PI / 2);
  const { position, uv } = geometry.attributes;
  for (let i = 0; i < position!.count; i++) uv!.setXY(i, position!.getX(i), position!.getZ(i));
  const material = new MeshStandardMaterial({ map: lines(), roughness: 0.95 });
  const floor = new Mesh(geometry, material);
  floor.name = 'floor';
  floor.receiveShadow = true;
  floor.position.set(middle.x, bounds.min.y, middle.z);
  return floor;
}

function lines(): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 128;
  const context = canvas.getContext('2d')!;
  context.fillStyle = '#c9bfa9';
  context.fillRect(0, 0, 128, 128);
  context.strokeStyle = '#ad9f86';
  context.lineWidth = 3;
  context.strokeRect(0, 0, 128, 128);
  const texture = new CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 8;
  return texture;
}
