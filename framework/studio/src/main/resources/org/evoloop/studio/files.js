// Which files and machines are shown: the pair, another file, a new one, and two texts side by side.
import { $, button, make, showDialog } from './dom.js';
import { ask } from './server.js';

const DIALECTS = [['mermaid', 'Mermaid', '.mmd'], ['plantuml', 'PlantUML', '.puml'], ['scxml', 'SCXML', '.scxml']];
const KEY = 'evoloop-studio-pair|';

export class Files {
  #store;
  #actions;

  // actions: { open(path), choose(side, path, name) }.
  constructor(store, actions) {
    this.#store = store;
    this.#actions = actions;
    for (const side of ['new', 'original']) {
      const select = $(`.view[data-side="${side}"] figcaption select`);
      select.onchange = () => {
        const [path, name] = JSON.parse(select.value);
        this.#actions.choose(side, path, name);
      };
    }
  }

  // [path, name] of each machine: on disk, or typed here.
  machines() {
    const { files, documents } = this.#store;
    const listed = files.filter(file => file.kind === 'models').flatMap(({ path, machines }) => (machines.length > 1 ? machines.map(name => [path, name]) : [[path, '']]));
    const typed = [...documents.values()].filter(one => one.kind === 'models' && !files.some(file => file.path === one.path)).map(one => [one.path, '']);
    return [...listed, ...typed];
  }

  // The pair that was chosen last, or the one that its names suggest.
  async first() {
    const kept = JSON.parse(localStorage.getItem(KEY + this.#store.directory) ?? '{}');
    const machines = this.machines();
    const known = one => one && (machines.some(([path, name]) => path === one.path && (name === (one.name ?? '') || !one.name)) || this.#store.orphans.includes(one.path));
    const guess = (side, words) => {
      const hit = machines.find(([path, name]) => words.test(name || path.split('/').at(-1)));
      return known(kept[side]) ? kept[side] : hit ? { path: hit[0], ...(hit[1] ? { name: hit[1] } : {}) } : null;
    };
    const original = guess('original', /original|device/i) ?? this.#reference(machines[0]);
    const evolved = guess('new', /new|evolved|after/i) ?? this.#reference(machines.find(([path, name]) => path !== original?.path || name !== (original?.name ?? '')));
    for (const one of [evolved, original]) if (one) await this.#store.open(one.path);
    return { new: evolved, original };
  }

  #reference(machine) { return machine ? { path: machine[0], ...(machine[1] ? { name: machine[1] } : {}) } : null; }

  selects(chosen) {
    const machines = this.machines();
    const files = new Set(machines.map(([path]) => path)).size;
    const named = ([path, name]) => (!name ? path : files > 1 ? `${name} in ${path}` : name);
    for (const side of ['new', 'original']) {
      const select = $(`.view[data-side="${side}"] figcaption select`);
      if (document.activeElement === select) continue;
      const value = JSON.stringify([chosen[side]?.path, chosen[side]?.name ?? '']);
      select.replaceChildren(...(chosen[side] ? [] : [make('option', { value: '[]' }, 'none yet')]), ...machines.map(one => make('option', { value: JSON.stringify(one) }, named(one))));
      select.value = chosen[side] ? value : '[]';
      select.hidden = machines.length < 2;
    }
  }

  welcome() { this.#create('There is no model here yet'); }

  dialog() {
    const listed = [...this.#store.files.map(one => one.path), ...this.#store.documents.keys()];
    const names = [...new Set(listed)].sort();
    showDialog('Files', [
      make('p.soft.small', {}, this.#store.directory),
      make('div.choice', {}, ...names.map(path => button(path, () => { $('#dialog').close(); this.#actions.open(path); }))),
    ], [button('New models …', () => this.#create('New models')), button('New device file or properties …', () => this.#text())]);
  }

  #create(title) {
    const dialect = make('select', { id: 'dialect' }, ...DIALECTS.map(([value, name]) => make('option', { value }, name)));
    const which = make('select', { id: 'which' }, make('option', { value: 'both' }, 'both: the device itself, and the new one'), make('option', { value: 'new' }, 'the new one'), make('option', { value: 'original' }, 'the device itself'));
    const told = make('p.bad', { role: 'status' });
    const create = async event => {
      event.preventDefault();
      const [, , ending] = DIALECTS.find(([value]) => value === dialect.value);
      try {
        const sides = which.value === 'both' ? ['original', 'new'] : [which.value];
        const taken = sides.map(side => side + ending).find(path => this.#store.get(path) || this.#store.files.some(file => file.path === path));
        if (taken) throw new Error(`There is ${taken} already.`);
        const { text } = await ask('POST', '/api/edit', { path: `new${ending}`, text: '', edit: { kind: 'new-file', dialect: dialect.value } });
        for (const side of sides) this.#store.create(side + ending, text);
        $('#dialog').close();
        for (const side of sides) await this.#actions.choose(side, side + ending, '');
      } catch (failure) {
        told.textContent = failure.message;
      }
    };
    const form = make('form.fields', { onsubmit: create }, make('label', {}, 'Which', which), make('label', {}, 'Written as', dialect), make('button.btn.main', { type: 'submit', id: 'begin' }, 'Begin'));
    showDialog(title, [make('p', {}, 'Each model is a text of its own, original and new. Nothing is written to the disk before you save.'), form, told]);
    $('#begin').focus();
  }

  #text() {
    const name = make('input', { type: 'text', required: true, placeholder: 'device.yaml or new.properties.txt' });
    const create = event => {
      event.preventDefault();
      const path = name.value.trim();
      if (!this.#store.get(path) && !this.#store.files.some(file => file.path === path)) this.#store.create(path, '\n');
      $('#dialog').close();
      this.#actions.open(path);
    };
    showDialog('A new file', [make('form.fields', { onsubmit: create }, make('label', {}, 'Name', name), make('button.btn.main', { type: 'submit' }, 'Begin'))]);
    name.focus();
  }

  // Two texts side by side: lines that are only in one of them are marked.
  compare(path, theirs, mine) {
    const side = (title, text, other) => make('div', {}, make('h3', {}, title), make('pre.mono.small.compared', {}, ...text.split('\n').map(line => make(other.split('\n').includes(line) ? 'div' : 'div.other', {}, line || ' '))));
    showDialog(`Two texts of ${path}`, make('div.cols', {}, side('Yours', mine, theirs), side('The other', theirs, mine)));
  }
}
