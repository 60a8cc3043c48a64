// A run of the two models: the converter's own core, with the device played by its model. The run is a list of inputs; each request
// replays it, so going back is a shorter list.
import { $, button, make, showDialog } from './dom.js';
import { Latest, ask } from './server.js';

const whole = text => { // "90000 ms" as "1 min 30 s"
  let left = Number.parseInt(text, 10);
  const parts = [];
  for (const [unit, size] of [['d', 86_400_000], ['h', 3_600_000], ['min', 60_000], ['s', 1_000], ['ms', 1]]) {
    if (left >= size) parts.push(`${Math.floor(left / size)} ${unit}`);
    left %= size;
  }
  return parts.join(' ') || '0 s';
};

const named = input => {
  if (input.after) return `let ${/^\d+ ms$/.test(input.after) ? whole(input.after) : input.after} pass`;
  if (input.guard) return `${input.guard} is ${input.value}`;
  return input.press ?? `${input.device} at the device`;
};

const only = one => Object.fromEntries(['press', 'device', 'after', 'guard', 'value'].filter(name => one[name] !== undefined).map(name => [name, one[name]]));
const sent = list => (list.length ? `sends ${list.join(', ')}` : 'nothing is sent');

export class Try {
  #place = $('#try');
  #latest = new Latest();
  #pair;
  #scenario;
  #answer = null;
  #failure = '';
  run = [];
  onStates = () => {};

  // pair: () -> the pair of a request, or null. scenario: (yaml) -> puts it into the device file, or null if there is none.
  constructor(pair, scenario) {
    this.#pair = pair;
    this.#scenario = scenario;
  }

  get states() { return this.#answer?.states ?? null; }

  async refresh() {
    const pair = this.#pair();
    if (!pair) {
      this.#answer = null;
    } else {
      try {
        const answer = await this.#latest.ask('/api/try', { pair, run: this.run });
        if (answer === null) return;
        this.#answer = answer.mistake ? null : answer;
        this.#failure = answer.mistake ? `Line ${answer.mistake.line}: ${answer.mistake.message}` : '';
      } catch (failure) {
        if (failure.status === 0) return; // the server has ended: what is shown stays
        this.#answer = null;
        this.#failure = failure.message;
      }
    }
    this.#show();
    this.onStates(this.states, this.#answer?.steps.at(-1) ?? null);
  }

  play(run) {
    this.run = run.map(only);
    return this.refresh();
  }

  #add(input) { return this.play([...this.run, input]); }

  #show() {
    const focused = document.activeElement?.closest('#try')?.querySelector(':focus')?.textContent;
    if (!this.#answer) {
      this.#place.replaceChildren(make('p.soft.small', {}, this.#failure || 'Two models can be tried: choose or draw them first.'),
        ...(this.run.length ? [button('From the start', () => this.play([]))] : []));
      return;
    }
    const { states, time, steps, possible, impossible, guards = [] } = this.#answer;
    const offers = possible.map(one => make('li', {},
      button(named(one), () => this.#add(only(one))),
      make('span', {}, one.target ? make('span', {}, '→ ', one.target, make('br')) : '', make('span.soft', {}, one.words))));
    const none = impossible.map(one => one.press).join(', ');
    const time$ = make('input', { type: 'text', placeholder: '10 s', ariaLabel: 'Time to let pass', size: 6 });
    const pass = () => { if (time$.value.trim()) this.#add({ after: time$.value.trim() }); };
    time$.addEventListener('keydown', key => { if (key.key === 'Enter') pass(); });
    this.#place.replaceChildren(
      make('div.where', { role: 'status' }, make('span', {}, 'Now ', make('span.st.now', { id: 'try-new' }, states.new)), make('span.soft', {}, 'the device itself ', make('span.st', { id: 'try-device' }, states.original)), make('span.soft', {}, whole(time))),
      make('ul.evs', { ariaLabel: 'Events' }, ...offers,
        make('li', {}, time$, make('span', {}, button('let it pass', pass))),
        ...(none ? [make('li.none', {}, `No effect in ${states.new}: ${none}`)] : [])),
      ...(guards.length ? [make('div.bar', { role: 'group', ariaLabel: 'Guards' }, ...guards.map(({ name, value }) =>
        button(`[${name}] ${value ? 'holds' : 'does not hold'}`, () => this.#add({ guard: name, value: !value }), { ariaPressed: String(value) })))] : []),
      make('div', {}, make('h3', {}, 'So far'), make('ol.run', {}, ...(steps.length ? steps.map((step, i) => make('li', {}, make('span.soft.num', {}, String(i + 1)),
        make('span', {}, make('b', {}, named(step.input)), `: ${step.states.new}`, make('br'), make(`span.${step.refused ? 'bad' : 'soft'}`, {}, step.refused ? step.words : `${sent(step.sent)}${step.words ? `; ${step.words}` : ''}`))))
        : [make('li', {}, make('span'), make('span.soft', {}, 'Press an event. Nothing is sent to a real device here.'))]))),
      make('div.bar', {}, this.#only(button('One back', () => this.play(this.run.slice(0, -1)), { id: 'back' })), this.#only(button('From the start', () => this.play([]), { id: 'again' })),
        this.#only(button('Keep as scenario', () => this.#keep()))));
    if (focused) [...this.#place.querySelectorAll('button')].find(one => one.textContent === focused)?.focus();
  }

  #only(one) { // if there is a run
    one.disabled = !this.run.length;
    return one;
  }

  #keep() {
    const title = make('input', { type: 'text', value: `After ${this.run.map(named).join(', ')}`.slice(0, 60), ariaLabel: 'Title of the scenario' });
    const told = make('p', { role: 'status' });
    const keep = async () => {
      try {
        const { yaml } = await ask('POST', '/api/scenario', { pair: this.#pair(), run: this.run, title: title.value.trim() });
        const where = await this.#scenario(yaml);
        if (where) dialog.close();
        else told.replaceChildren('There is no device file here; put this under its scenarios:', make('pre.mono', {}, yaml));
      } catch (failure) {
        told.className = 'bad';
        told.textContent = failure.message;
      }
    };
    const dialog = showDialog('Keep this run as a scenario', [make('div.fields', {}, make('label', {}, 'Title', title)), told],
      [make('p.soft', {}, '`evoloop check` plays it again, and fails if something else is sent.'), make('button.btn.main', { type: 'button', onclick: keep }, 'Keep it')]);
  }
}
