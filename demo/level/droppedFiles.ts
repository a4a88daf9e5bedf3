import type { PathedFile } from './LevelFiles.js';

/** More files than this in a folder are no level's: the rest is left. */
const MOST = 5000;

/** The files of a picker. */
export function pickedFiles(list: FileList): PathedFile[] {
  return Array.from(list, (file) => ({ path: file.webkitRelativePath || file.name, file }));
}

/**
 * The files of a drop, those in its folders too. To be called in the event's own turn: its data are gone afterwards.
 */
export async function droppedFiles({ items, files }: DataTransfer): Promise<PathedFile[]> {
  const entries = Array.from(items).map((item) => item.webkitGetAsEntry());
  const found: PathedFile[] = Array.from(files, (file) => ({ path: file.name, file }));
  if (!entries.some((entry) => entry?.isDirectory)) return found;
  const inside: PathedFile[] = [];
  for (const entry of entries) if (entry !== null) await read(entry, '', inside);
  return inside;
}

async function read(entry: FileSystemEntry, folder: string, into: PathedFile[]): Promise<void> {
  if (into.length >= MOST) return;
  const path = folder + entry.name;
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) =>
      (entry as FileSystemFileEntry).file(resolve, reject),
    );
    into.push({ path, file });
    return;
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  // It tells them by the hundred, until it has no more.
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) =>
      reader.readEntries(resolve, reject),
    );
    if (some.length === 0) return;
    for (const each of some) await read(each, `${path}/`, into);
  }
}
