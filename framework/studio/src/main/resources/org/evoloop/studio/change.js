// What is drawn goes to a running converter, in four steps: look, try beside, take over, watch.
import { $, button, make, showDialog } from './dom.js';
import { ask } from './server.js';

const STAGES = [['look', '1. Look', 'what becomes of each state'], ['beside', '2. Try beside', 'it decides, nothing is sent'], ['over', '3. Take over', 'with a way back'], ['watch', '4. Watch', 'goes back by itself']];

export class Change {
  #desk;
  #name = '';
  #stage = 'look';
  #body = make('div.stage');
  #runs = make('select', { ariaLabel: 'What runs now' });
  #chosen = null;
  #told = make('p.said', { role: 'status' });
  #probation = make('input', { type: 'text', value: '600', inputMode: 'numeric', ariaLabel: 'Probation in seconds' });

  // desk: { pair(), reference(side), machines(), unsaved(), save() }.
  constructor(desk) { this.#desk = desk; }

  async open() {
    this.#stage = 'look';
    this.#told.textContent = '';
    let names = [];
    let note = '';
    try {
      ({ names, note = '' } = await ask('GET', '/api/converters'));
    } catch (failure) {
      note = failure.message;
    }
    if (!names.length) {
      showDialog('Run it', [make('p', {}, 'No converter runs on this machine that can be asked.'), ...(note ? [make('p.soft.small', {}, note)] : []),
        make('p.soft', {}, 'Start one with the device file, then open this again.')]);
      return;
    }
    this.#name = names.includes(this.#name) ? this.#name : names[0];
    const which = make('select', { ariaLabel: 'The running converter', onchange: () => { this.#name = which.value; this.#show(); } }, ...names.map(name => make('option', { value: name }, name)));
    which.value = this.#name;
    const tabs = make('div.stages', { role: 'tablist', ariaLabel: 'Steps' }, ...STAGES.map(([stage, title, words]) => make('button', { type: 'button', role: 'tab', value: stage, onclick: () => { this.#stage = stage; this.#show(); } }, make('b', {}, title), make('span', {}, words))));
    const dialog = showDialog(`${this.#desk.reference('new')} for a running device`, [make('div.fields', {}, make('label', {}, 'Converter', which)), this.#body, this.#told]);
    $('header', dialog).append(tabs);
    this.#show();
  }

  async #command(command, more = {}) {
    this.#told.className = 'said soft';
    this.#told.textContent = 'Asking …';
    try {
      const failures = this.#desk.unsaved().length && more.new ? await this.#desk.save() : [];
      if (failures.length) throw new Error(`Nothing was done, since ${failures.join('; ')}.`);
      const answer = await ask('POST', `/api/converters/${encodeURIComponent(this.#name)}`, { command, pair: this.#desk.pair(), ...more });
      if (answer.mistake) throw new Error(`Line ${answer.mistake.line}: ${answer.mistake.message}`);
      this.#told.textContent = command === 'migrate' ? '' : answer.words;
      return answer;
    } catch (failure) {
      this.#told.className = 'said bad';
      this.#told.textContent = failure.message;
      return null;
    }
  }

  // In seconds, none for zero; null if it is no number, which is told.
  #probationOf() {
    const written = this.#probation.value.trim();
    if (/^\d{1,7}$/.test(written)) return Number(written) ? { probation: Number(written) } : {};
    this.#told.className = 'said bad';
    this.#told.textContent = `Nothing was done: '${written}' is no number of seconds. Write 600, or 0 for no way back by itself.`;
    this.#probation.focus();
    return null;
  }

  async #status() {
    try {
      return await ask('GET', `/api/converters/${encodeURIComponent(this.#name)}`);
    } catch (failure) {
      this.#told.textContent = failure.message;
      return null;
    }
  }

  #here(status) {
    const { newState: now, originalState: device } = status;
    return make('div.here', {}, 'Now ', make('span.st.now', {}, now || 'in doubt'), ...(device ? [make('span', {}, 'the device itself ', make('span.st', {}, device))] : []), ...(status.evolution ? [make('span', {}, status.evolution)] : []));
  }

  async #show() {
    const stage = this.#stage;
    for (const tab of document.querySelectorAll('#dialog .stages button')) tab.ariaSelected = String(tab.value === stage);
    const main = (text, onclick) => make('button.btn.main', { type: 'button', onclick }, text);
    const next = { new: this.#desk.reference('new'), original: this.#desk.reference('original') };
    const warned = this.#desk.unsaved().length ? [make('p.soft.small', {}, 'What is not saved is saved first: the converter reads the file.')] : [];
    const status = await this.#status();
    if (stage !== this.#stage) return;
    const here = status ? [this.#here(status)] : [];
    if (stage === 'look') {
      this.#which(status);
      const place = make('div.stage', {}, make('p.soft', {}, 'Asking …'));
      const look = async () => {
        const answer = await this.#command('migrate', this.#running());
        place.replaceChildren(...(answer ? [table(answer)] : []));
      };
      this.#runs.onchange = () => {
        this.#chosen = JSON.parse(this.#runs.value);
        look();
      };
      this.#body.replaceChildren(...here, make('div.fields', {}, make('label', {}, 'What runs now, as it is on the disk', this.#runs)), place);
      await look();
    } else if (stage === 'beside') {
      this.#body.replaceChildren(...here, make('p', {}, 'It decides beside the present model, with each event. Nothing of it is sent.'), ...warned,
        make('div.bar', {}, main('Try it beside', () => this.#command('shadow', { new: next.new })), button('What has it decided?', () => this.#command('shadow')), button('No longer', () => this.#command('off')), button('Let it take over', () => this.#command('promote'))));
    } else if (stage === 'over') {
      this.#body.replaceChildren(...here, make('p', {}, 'The running device goes on with the new model, from the state in which it is.'), ...warned,
        make('div.fields', {}, make('label', {}, 'Goes back by itself if something fails within (seconds)', this.#probation)),
        make('div.bar', {}, main('Let it take over', async () => {
          const probation = this.#probationOf();
          const answer = probation && await this.#command('evolve', { ...next, ...probation });
          if (answer) { const said = answer.words; this.#stage = 'watch'; await this.#show(); this.#told.textContent = said; }
        })));
    } else {
      this.#body.replaceChildren(...here, make('div.bar', {}, button('Look again', () => this.#show()), button('Roll back', async () => {
        const answer = await this.#command('rollback');
        if (answer) { const said = answer.words; await this.#show(); this.#told.textContent = said; }
      })), make('details', {}, make('summary', {}, 'All that it says'), make('pre.mono.small', {}, JSON.stringify(status, null, 2))));
    }
  }

  // What runs is not known by its file, only by its name; one may say which it is.
  #which(status) {
    const name = /'([^']+)'/.exec(status?.evolution ?? '')?.[1];
    const machines = this.#desk.machines();
    const guess = machines.find(([path, machine]) => (machine || path.replace(/^.*\/|\.[^.]+$/g, '')) === name);
    this.#runs.replaceChildren(...machines.map(one => make('option', { value: JSON.stringify(one) }, one[1] ? `${one[0]}#${one[1]}` : one[0])));
    this.#runs.value = JSON.stringify(guess ?? this.#chosen ?? [this.#desk.pair().new.path, this.#desk.pair().new.name ?? '']);
  }

  #running() {
    const [path, name] = JSON.parse(this.#runs.value);
    return { running: { original: this.#desk.pair().original, new: { path, ...(name ? { name } : {}) } } };
  }
}

// Migrate's table: how many pairs of states go over and how, and which they are.
const FATES = [
  ['good', 'go over at once', row => row.toNewState && !row.events.length],
  ['warn', 'by sending something', row => row.toNewState && row.events.length],
  ['warn', 'wait for an event', row => !row.toNewState && row.reason !== undefined && (row.exits.length || row.uncertain.length)],
  ['bad', 'impossible', () => true],
];

function fate(row) {
  if (row.toNewState) return `${row.toNewState === row.newState ? 'goes over at once' : `becomes ${row.toNewState}`}${row.events.length ? `, by ${row.events.join(', ')}` : ''}`;
  if (row.exits.length) return `waits until ${row.exits.join(' or ')}`;
  return row.reason ?? 'waits';
}

function table({ words, table: { pairs } }) {
  const sums = FATES.map(() => 0);
  const groups = new Map();
  for (const row of pairs) {
    const kind = FATES.findIndex(([, , is]) => is(row));
    sums[kind]++;
    const key = fate(row);
    groups.set(key, { kind, states: [...(groups.get(key)?.states ?? []), row.newState] });
  }
  return make('div.stage', {},
    make('div.sum', {}, ...FATES.map(([tone, title], i) => make('div', {}, make(`b${sums[i] ? `.${tone}` : ''}`, {}, String(sums[i])), title))),
    make('table.stack.first-wide', {}, make('thead', {}, make('tr', {}, make('th', {}, 'If it is in'), make('th', {}, 'then it'))),
      make('tbody', {}, ...[...groups].map(([key, { kind, states }]) => make('tr', {},
        make('td', { 'data-th': 'If it is in' }, ...[...new Set(states)].map(state => [make('span.st', {}, state), ' ']).flat()),
        make(`td.${FATES[kind][0]}`, { 'data-th': 'then it' }, key))))),
    make('details', {}, make('summary', {}, 'All pairs, in words'), make('pre.mono.small.wrap', {}, words)));
}
