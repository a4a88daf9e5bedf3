import { Vector3, type WebGLRenderer } from 'three';
import './level.css';
import { DEFAULT_LEVEL } from '../parameters.js';
import { droppedFiles, pickedFiles } from './droppedFiles.js';
import { EXAMPLES } from './examples.js';
import type { Level } from './Level.js';
import type { PathedFile } from './LevelFiles.js';
import { LevelMenu, metres } from './LevelMenu.js';
import { LevelNews } from './LevelNews.js';
import { type Loaded, loadLevel, type Progress, readLevel } from './loadLevel.js';

/** The scene that levels come into. */
export interface Stage {
  readonly renderer: WebGLRenderer;
  /** The one that is walked in. */
  readonly level: Level | null;
  /** Settled once the page's first level is there, or has failed. */
  readonly ready: Promise<unknown>;
  /** Puts a level in the place of the last one, which it frees. */
  enter(level: Level): Promise<void>;
  /** Puts the character at the level's start. */
  begin(): void;
  /** Makes the start where the character is. */
  keepStart(): void;
  /** Takes away what lies over the picture, and walks. */
  walk(): void;
}

export interface Levels {
  /** Files that belong together. Settled once one walks among them, or the page has said why not. */
  open(files: readonly PathedFile[]): Promise<void>;
  visit(url: string): Promise<void>;
}

/** Lets the user bring levels: dropped on the page, picked, or out of a list. */
export function createLevels(stage: Stage): Levels {
  const news = new LevelNews(document.body);
  const menu = new LevelMenu(document.body, {
    pick: () => picker.click(),
    visit: (url) => void levels.visit(url),
    place(placing) {
      stage.level?.place(placing);
      stage.begin();
    },
    again: () => stage.begin(),
    here: () => stage.keepStart(),
  });
  const picker = createPicker((files) => void levels.open(files));
  let turns = 0;

  /** The newest call wins; a level that nobody waits for any more is freed. */
  async function take(name: string, load: (progress: Progress) => Promise<Loaded>): Promise<void> {
    const turn = ++turns;
    const outdated = () => turn !== turns;
    news.progress(`Loading ${name}…`, NaN);
    await stage.ready;
    await drawn();
    try {
      const { level, missing } = await load((part) => {
        if (!outdated()) news.progress(`Loading ${name}…`, part);
      });
      if (outdated()) return level.dispose();
      news.progress(`Preparing ${name}…`, NaN);
      await drawn();
      await stage.enter(level);
      menu.show(level);
      menu.open(false);
      stage.walk();
      tell(level, missing);
    } catch (error) {
      if (!outdated()) news.fail(error instanceof Error ? error.message : String(error));
    }
  }

  function tell(level: Level, missing: string[]): void {
    const size = level.bounds.getSize(new Vector3()).toArray().map(metres).join(' × ');
    const without =
      missing.length > 0 ? ` Without pictures that were not dropped: ${list(missing)}.` : '';
    if (EXAMPLES.some(({ url }) => url.endsWith(`/${level.name}`))) news.clear();
    else
      news.note(
        `${level.name} is ${size} m. Not as it should be? Adjust it under “Level”.${without}`,
      );
  }

  const levels: Levels = {
    open(files) {
      const name = files.length === 1 ? files[0]!.file.name : `${files.length} files`;
      return take(name, (progress) => readLevel(files, stage.renderer, progress));
    },
    visit(url) {
      const name = EXAMPLES.find((each) => each.url === url)?.name ?? url;
      return take(name, async (progress) => ({
        level: await loadLevel(url, stage.renderer, progress),
        missing: [],
      }));
    },
  };
  offer(() => picker.click(), levels.visit);
  void stage.ready.then(() => stage.level && menu.show(stage.level));
  acceptDrops(news, (files) => void levels.open(files));
  return levels;
}

/** A line on the start screen. */
function offer(pick: () => void, visit: (url: string) => Promise<void>): void {
  const line = document.createElement('p');
  line.className = 'level-offer';
  const button = (text: string, act: () => void) => {
    const made = document.createElement('button');
    made.type = 'button';
    made.textContent = text;
    made.addEventListener('click', act);
    return made;
  };
  const others = EXAMPLES.filter(({ url }) => url !== DEFAULT_LEVEL).map(({ name, url }) =>
    button(name, () => void visit(url)),
  );
  const drop = document.createElement('span');
  drop.textContent = 'Or drop a .glb anywhere, or try another level:';
  line.append(drop, button('Open a .glb', pick), ...others);
  document.querySelector('.action')?.after(line);
}

function createPicker(picked: (files: PathedFile[]) => void): HTMLInputElement {
  const picker = document.createElement('input');
  picker.type = 'file';
  picker.multiple = true;
  picker.hidden = true;
  picker.id = 'level-files';
  picker.setAttribute('aria-label', 'Level files');
  picker.addEventListener('change', () => {
    if (picker.files !== null && picker.files.length > 0) picked(pickedFiles(picker.files));
    picker.value = ''; // the same file may be picked again
  });
  document.body.append(picker);
  return picker;
}

/** The whole page takes files. */
function acceptDrops(news: LevelNews, dropped: (files: PathedFile[]) => void): void {
  const withFiles = ({ dataTransfer }: DragEvent) => dataTransfer?.types.includes('Files') === true;
  window.addEventListener('dragover', (event) => {
    if (!withFiles(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = 'copy';
    news.dragging(true);
  });
  window.addEventListener('dragleave', ({ relatedTarget }) => {
    if (relatedTarget === null) news.dragging(false);
  });
  window.addEventListener('drop', (event) => {
    news.dragging(false);
    if (!withFiles(event)) return;
    event.preventDefault();
    droppedFiles(event.dataTransfer!).then(dropped, (error: unknown) =>
      news.fail(`These files cannot be read: ${String(error)}. Pick them under “Level”.`),
    );
  });
}

/** Until what the page says now has been drawn: what comes next may keep it busy. */
function drawn(): Promise<void> {
  return new Promise((resolve) => {
    const later = () => setTimeout(resolve);
    requestAnimationFrame(later);
    setTimeout(resolve, 100); // a hidden page draws nothing
  });
}

function list(names: string[]): string {
  const more = names.length > 3 ? ` and ${names.length - 3} more` : '';
  return names.slice(0, 3).join(', ') + more;
}
