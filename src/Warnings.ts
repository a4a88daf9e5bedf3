/** Says each thing once, in the console, under the name of its class: a bad frame comes sixty times a second. */
export class Warnings {
  readonly #said = new Set<string>();

  /** @param name the class on whose behalf it warns */
  constructor(readonly name: string) {}

  once(message: string): void {
    if (this.#said.has(message)) return;
    this.#said.add(message);
    console.warn(`${this.name}: ${message}`);
  }
}
