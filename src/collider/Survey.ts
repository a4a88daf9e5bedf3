import { type Mesh, type Object3D, Vector3 } from 'three';
import { isRigid } from './isRigid.js';
import { solidityOf } from './isSolid.js';
import type { ObjectProxy } from './objectProxy.js';
import { SceneIndex } from './SceneIndex.js';
import { SceneWalk, type SelectionRules, type WalkListener } from './SceneWalk.js';
import { SeenMesh } from './SeenMesh.js';

/** What has become of the scenery around the last draw. */
export interface SurveyReport {
  /** Something solid within reach has another world matrix than when it was drawn last. */
  moved: boolean;
  /** Something solid within reach came, went, or changed its shape since it was drawn last; or nothing was drawn yet. */
  changed: boolean;
  /** Something solid within reach may deform unseen by the processor: a skin, a morph, a shader. */
  deforms: boolean;
  /** Objects within reach that report and do not block: `object.userData.sensor === true`. */
  readonly sensors: Object3D[];
}

/** Looks, between draws, at what the last one showed: whether a field kept from it still tells the truth. */
export class Survey {
  readonly report: SurveyReport = { moved: false, changed: true, deforms: false, sensors: [] };
  readonly #seen = new WeakMap<Mesh, SeenMesh>();
  readonly #center = new Vector3();
  #far = 0;
  /** Number of the last draw, among those noted; 0 while none counts. */
  #draw = 0;
  #draws = 0;
  /** How many that draw showed, and how many of them were found again. */
  #drawn = 0;
  #found = 0;
  #sensors = 0;
  #rules!: SelectionRules;

  readonly #index: SceneIndex;
  readonly #walk: SceneWalk;
  readonly #listener: WalkListener = {
    solid: (mesh) => {
      const { report } = this;
      this.#found++;
      const solidity = solidityOf(mesh, this.#rules.transparent);
      if (!report.deforms && !isRigid(mesh, solidity)) report.deforms = true;
      if (this.#draw === 0) return;
      const seen = this.#seen.get(mesh);
      if (seen === undefined || seen.draw !== this.#draw) {
        report.changed = true;
      } else {
        if (!report.moved && seen.moved(mesh)) report.moved = true;
        if (!report.changed && seen.changed(mesh)) report.changed = true;
      }
    },
    sensor: (object) => {
      this.report.sensors[this.#sensors++] = object;
    },
  };

  /** @param index of what is where in the scene; shared with whoever selects from it */
  constructor(index = new SceneIndex()) {
    this.#index = index;
    this.#walk = new SceneWalk(index, this.#listener);
  }

  /**
   * Notes what a draw shows.
   *
   * @param center world space
   * @param far metres within which it was selected
   */
  note(proxies: readonly ObjectProxy[], center: Vector3, far: number): void {
    this.#draw = ++this.#draws;
    this.#drawn = proxies.length;
    this.#center.copy(center);
    this.#far = far;
    for (let i = 0; i < proxies.length; i++) {
      const { source } = proxies[i]!;
      let seen = this.#seen.get(source);
      if (seen === undefined) this.#seen.set(source, (seen = new SeenMesh()));
      seen.take(source, this.#draw);
    }
  }

  /** No draw counts any more: all is `changed` until the next. */
  forget(): void {
    this.#draw = 0;
  }

  /** Lets go of the user's objects. */
  clear(): void {
    this.forget();
    this.report.sensors.length = 0;
  }

  /**
   * Walks the scene by the rules of the last draw, around its centre; around `center` while there is none.
   *
   * @returns `report`
   */
  look(
    scene: Object3D,
    center: Vector3,
    far: number,
    rules: SelectionRules,
  ): Readonly<SurveyReport> {
    const { report } = this;
    const none = this.#draw === 0;
    report.moved = report.deforms = false;
    report.changed = none;
    this.#found = this.#sensors = 0;
    this.#rules = rules;
    this.#walk.walk(scene, none ? center : this.#center, none ? far : this.#far, rules, true);
    this.#index.surveyed = true;
    report.sensors.length = this.#sensors;
    if (this.#found !== this.#drawn) report.changed = true;
    return report;
  }

  /** The report where nothing could be looked at. */
  nothing(): Readonly<SurveyReport> {
    const { report } = this;
    report.moved = report.changed = report.deforms = false;
    report.sensors.length = 0;
    return report;
  }
}
