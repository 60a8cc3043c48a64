// The texts: what is on disk, what was typed, and the way back.
//
// What is typed is in localStorage with each key, under this window's own name, until it is saved. So neither a closed window, nor
// another window with the same file, nor a server that has ended takes anything away. What a closed window has left is taken over by
// the next one that opens the file.
import { ask } from './server.js';

const PAUSE = 800; // milliseconds, after which typing is another step
const MOST_STEPS = 1000;
const SOON = 1000; // milliseconds, in which a browser says which windows there are

export class Store extends EventTarget {
  #directory = '';
  #window = '';
  #steps = [];
  #undone = [];
  files = []; // as listed by the server
  documents = new Map(); // path -> { path, kind, text, saved, version, conflict, gone, left: [other texts] }
  unkept = false; // localStorage is full or forbidden

  async start() {
    this.#window = await ownWindow();
    await this.list();
  }

  async list() {
    const { directory, files } = await ask('GET', '/api/files');
    this.#directory = directory;
    this.files = files;
    return files;
  }

  get directory() { return this.#directory; }

  get(path) { return this.documents.get(path); }

  text(path) { return this.get(path)?.text ?? ''; }

  isUnsaved(path) {
    const one = this.get(path);
    return one !== undefined && one.text !== one.saved;
  }

  get unsaved() { return [...this.documents.keys()].filter(path => this.isUnsaved(path)); }

  // The unsaved texts, as requests bring them.
  get texts() { return Object.fromEntries(this.unsaved.map(path => [path, this.text(path)])); }

  async open(path) {
    if (this.documents.has(path)) return this.get(path);
    const kind = this.files.find(file => file.path === path)?.kind ?? kindOf(path);
    const { text, version } = await ask('GET', `/api/file?path=${encodeURIComponent(path)}`)
      .catch(failure => { if (failure.status === 404) return { text: null, version: '' }; throw failure; });
    const one = { path, kind, text: text ?? '', saved: text, version, conflict: null, left: [] };
    // What an open window types is its own, unless there is nothing else of this file.
    const known = await this.#drafts(path);
    const closed = known.filter(draft => !draft.alive);
    const drafts = closed.length || text !== null ? closed : known.slice(0, 1);
    if (drafts.length) {
      const [mine, ...others] = drafts;
      if (mine.version !== version && mine.text !== text) one.conflict = { text: text ?? '', version };
      Object.assign(one, { text: mine.text, ...(one.conflict ? { saved: mine.saved, version: mine.version } : {}) });
      one.left = others.map(draft => draft.text).filter(other => other !== one.text && other !== text);
    }
    this.documents.set(path, one);
    this.#keep(one);
    for (const draft of closed) if (draft.key !== this.#key(path) && draft.text === one.text) localStorage.removeItem(draft.key);
    this.#tell();
    return one;
  }

  // A file that is not on disk yet.
  create(path, text) {
    const one = { path, kind: kindOf(path), text: '', saved: null, version: '', conflict: null, left: [] };
    this.documents.set(path, one);
    this.change([[path, text]]);
    return one;
  }

  // Paths of which something typed is kept, although they are not on disk.
  get orphans() {
    const prefix = `evoloop-studio|${this.#directory}|`;
    return [...new Set(Object.keys(localStorage).filter(key => key.startsWith(prefix)).map(key => key.slice(prefix.length, key.lastIndexOf('|'))))];
  }

  // One step, which undo takes back: pairs of path and text. Typing in one place is one step until there is a pause.
  change(texts, { typed = false, at = null } = {}) {
    const changes = texts.filter(([path, after]) => this.text(path) !== after).map(([path, after]) => ({ path, before: this.text(path), after }));
    if (!changes.length) return;
    const last = this.#steps.at(-1);
    const now = performance.now();
    if (typed && last?.typed && now - last.when < PAUSE && last.changes[0].path === changes[0].path && !this.#undone.length) {
      last.changes[0].after = changes[0].after;
      last.when = now;
      last.at = at;
    } else {
      this.#steps.push({ changes, typed, when: now, at });
      if (this.#steps.length > MOST_STEPS) this.#steps.shift();
    }
    this.#undone = [];
    this.#put(changes.map(({ path, after }) => [path, after]));
  }

  get canUndo() { return this.#steps.length > 0; }

  get canRedo() { return this.#undone.length > 0; }

  undo() { return this.#move(this.#steps, this.#undone, 'before'); }

  redo() { return this.#move(this.#undone, this.#steps, 'after'); }

  // The path and the line of what has changed, or null.
  #move(from, to, side) {
    const step = from.pop();
    if (!step) return null;
    to.push({ ...step, typed: false });
    const { path } = step.changes[0];
    const old = this.text(path);
    this.#put(step.changes.map(change => [change.path, change[side]]));
    return { path, line: firstDifference(old, this.text(path)) };
  }

  #put(texts) {
    for (const [path, text] of texts) {
      const one = this.get(path);
      one.text = text;
      this.#keep(one);
    }
    this.#tell('text');
  }

  // Writes a file. What is on disk is never lost: if it is another text than the one that was read, both are kept.
  async save(path) {
    const one = this.get(path);
    const { text } = one;
    try {
      const { version } = await ask('PUT', '/api/file', { path, text, version: one.version });
      Object.assign(one, { saved: text, version, conflict: null, gone: false });
    } catch (failure) {
      if (failure.status !== 409) throw failure;
      this.#differs(one, failure.answer.version ? failure.answer : null);
    }
    this.#keep(one);
    this.#tell();
    return !one.conflict && !one.gone;
  }

  // Looks whether the disk has changed.
  async look(path) {
    const one = this.get(path);
    if (one.saved === null) return;
    const disk = await ask('GET', `/api/file?path=${encodeURIComponent(path)}`)
      .catch(failure => { if (failure.status === 404) return null; throw failure; });
    if (disk && (disk.version === one.version || disk.version === one.conflict?.version)) return;
    this.#differs(one, disk);
    this.#keep(one);
    this.#tell();
  }

  // disk: what is there now, or null.
  #differs(one, disk) {
    const untouched = one.text === one.saved;
    if (!disk) {
      Object.assign(one, { saved: null, version: '', conflict: null, gone: true });
    } else if (one.text === disk.text || untouched) {
      Object.assign(one, { saved: disk.text, version: disk.version, conflict: null });
      this.change([[one.path, disk.text]]);
    } else {
      one.conflict = disk;
    }
  }

  // Mine goes on; the next save writes it over the disk's.
  keepMine(path) {
    const one = this.get(path);
    Object.assign(one, { saved: one.conflict.text, version: one.conflict.version, conflict: null });
    this.#keep(one);
    this.#tell();
  }

  // The disk's goes on; undo brings mine back.
  takeTheirs(path) {
    const one = this.get(path);
    const { text, version } = one.conflict;
    Object.assign(one, { saved: text, version, conflict: null });
    this.change([[path, text]]);
    this.#tell();
  }

  // What another window has left: taken (undo brings mine back), or not.
  settle(path, text, taken) {
    const one = this.get(path);
    one.left = one.left.filter(other => other !== text);
    if (taken) this.change([[path, text]]);
    for (const key of this.#keys(path)) if (key !== this.#key(path) && JSON.parse(localStorage.getItem(key)).text === text) localStorage.removeItem(key);
    this.#tell();
  }

  #key(path) { return `evoloop-studio|${this.#directory}|${path}|${this.#window}`; }

  #keys(path) {
    const prefix = `evoloop-studio|${this.#directory}|${path}|`;
    return Object.keys(localStorage).filter(key => key.startsWith(prefix));
  }

  // What was typed in this and in other windows: mine first, then the newest.
  async #drafts(path) {
    const { held } = await Promise.race([navigator.locks.query(), new Promise(done => setTimeout(done, SOON, { held: null }))]);
    const names = held && new Set(held.map(lock => lock.name));
    const mine = this.#key(path);
    return this.#keys(path)
      .map(key => ({ key, alive: key !== mine && (!names || names.has(lockOf(key.slice(key.lastIndexOf('|') + 1)))), ...JSON.parse(localStorage.getItem(key)) }))
      .sort((a, b) => (b.key === mine) - (a.key === mine) || b.at - a.at);
  }

  #keep(one) {
    try {
      if (one.text === one.saved) localStorage.removeItem(this.#key(one.path));
      else localStorage.setItem(this.#key(one.path), JSON.stringify({ text: one.text, saved: one.saved, version: one.version, at: Date.now() }));
      this.unkept = false;
    } catch {
      this.unkept = true;
    }
  }

  #tell(what = 'state') { this.dispatchEvent(new CustomEvent('change', { detail: what })); }
}

const lockOf = id => `evoloop-studio-${id}`;

// A name for this window, which survives a reload. A copy of a window gets its own.
async function ownWindow() {
  let id = sessionStorage.getItem('evoloop-window') ?? crypto.randomUUID();
  while (!(await hold(lockOf(id)))) id = crypto.randomUUID();
  sessionStorage.setItem('evoloop-window', id);
  return id;
}

function hold(name) {
  return new Promise(done => {
    navigator.locks.request(name, { ifAvailable: true }, lock => {
      done(lock !== null);
      return lock === null ? undefined : new Promise(() => {}); // until the window is closed
    });
  });
}

function firstDifference(before, after) {
  const [old, fresh] = [before.split('\n'), after.split('\n')];
  const index = fresh.findIndex((line, i) => line !== old[i]);
  return (index < 0 ? fresh.length - 1 : index) + 1;
}

export function kindOf(path) {
  if (/\.ya?ml$/i.test(path)) return 'device';
  return /\.properties(\.txt)?$/i.test(path) ? 'properties' : 'models';
}
