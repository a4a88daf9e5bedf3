import { type AnimationClip, AnimationMixer, type Object3D, PropertyBinding } from 'three';

/** Plays a file's clips, all that do not contradict one another: of a figure that can walk and run, the first. */
export function playClips(root: Object3D, clips: readonly AnimationClip[]): AnimationMixer | null {
  if (clips.length === 0) return null;
  const mixer = new AnimationMixer(root);
  const moved = new Set<string>();
  for (const clip of clips) {
    const nodes = clip.tracks.map(({ name }) => PropertyBinding.parseTrackName(name).nodeName);
    if (nodes.some((node) => moved.has(node))) continue;
    for (const node of nodes) moved.add(node);
    mixer.clipAction(clip).play();
  }
  mixer.update(0);
  return mixer;
}
