// What is picked, with its fields. Each field is an edit of the text.
import { $, button, make } from './dom.js';

const field = (label, input) => make('label', {}, label, input);
const chosen = (names, value, first) => {
  const select = make('select', {}, ...(first ? [make('option', { value: '' }, first)] : []), ...names.map(name => make('option', { value: name }, name)));
  select.value = names.includes(value) ? value : '';
  return select;
};

// An event that the device raises by itself has a keyword in the text, and a box to tick here.
const OWN = '«spontaneous» ';
const marked = (events, own) => (own ? events.split(',').map(one => OWN + one.trim()).join(', ') : events);
const box = (id, checked) => Object.assign(make('input', { type: 'checkbox', id, title: 'The device does it without being told' }), { checked });

// The event's name without the keyword; null if there is none, or more than a box can say.
function nameOf(trigger) {
  const name = trigger.startsWith(OWN) ? trigger.slice(OWN.length) : trigger;
  return /^tm\(|[«,]/.test(name) ? null : name || null;
}

const names = model => (model?.states ?? []).map(one => one.name);

export class Strip {
  #place = $('#strip');
  #model;
  #edit;
  #words = make('span.plan-says', { role: 'status' });
  #what = '';

  // model: side -> its last good model. edit: (side, edit) -> a promise.
  constructor(model, edit) {
    this.#model = model;
    this.#edit = edit;
    this.#place.addEventListener('keydown', key => {
      if (key.key === 'Escape') { this.#what = ''; this.onLeft(); }
    });
  }

  onLeft = () => {};

  // The plan, or why an edit was refused.
  say(text, tone = '') {
    this.#words.textContent = text;
    this.#words.className = `plan-says ${tone}`;
  }

  // After a drawing: a form, or a field in which one types, is not taken away.
  update(picked) {
    const here = document.activeElement;
    const busy = this.#place.contains(here) && here.matches('input') && here.value !== here.dataset.sent;
    if (this.#what === 'form' || busy) return;
    const id = this.#place.contains(here) ? here.id : '';
    this.show(picked);
    if (id) document.getElementById(id)?.focus();
  }

  show(picked) {
    const what = JSON.stringify([picked?.side, picked?.state?.name, picked?.transition?.id]);
    if (what !== this.#what) this.say('');
    this.#what = what;
    if (picked?.state) this.#state(picked);
    else if (picked?.transition) this.#transition(picked);
    else this.#place.replaceChildren(make('span.soft', {}, 'Click a state or an arrow, or put the cursor in its line. S adds a state, A an arrow.'), this.#words);
  }

  #changed(input, work) { // Enter, or leaving the field
    input.dataset.sent = input.value;
    input.addEventListener('change', () => {
      if (input.value === input.dataset.sent) return;
      input.dataset.sent = input.value;
      work(input.value.trim());
    });
    return input;
  }

  #state({ side, state }) {
    const own = this.#model('original');
    const device = this.#changed(chosen(names(own), state.device, 'stays where it is'), to => this.#edit(side, { kind: 'set-device-state', state: state.name, device: to }));
    const isNew = side === 'new' && !names(own).includes(state.name);
    this.#place.replaceChildren(
      field('State', this.#changed(make('input', { type: 'text', value: state.name, id: 'state-name' }), to => this.#edit(side, { kind: 'rename-state', from: state.name, to }))),
      ...(isNew && own ? [field('the device meanwhile', device)] : []),
      button('Begins here', () => this.#edit(side, { kind: 'set-initial', state: state.name })),
      button('+ Arrow', () => this.arrow(side, state.name)),
      button('Delete', () => this.#edit(side, { kind: 'delete-state', state: state.name }), { id: 'delete' }),
      this.#words);
    if (!this.#words.textContent) this.say(side === 'new' && !isNew ? 'Its name is changed in both models.' : 'Drag from the ring to a state, or press A, for an arrow.', 'soft');
  }

  #transition({ side, transition }) {
    const { line, source, target, trigger, guard } = transition;
    const all = names(this.#model(side));
    const name = side === 'original' ? nameOf(trigger) : null;
    const own = box('own', trigger.startsWith(OWN));
    const event = this.#changed(make('input', { type: 'text', value: name ?? trigger, id: 'trigger' }), () => retrigger());
    const retrigger = () => this.#edit(side, { kind: 'set-trigger', line, event: marked(event.value.trim(), name !== null && own.checked) });
    own.addEventListener('change', retrigger);
    this.#place.replaceChildren(
      this.#changed(Object.assign(chosen(all, source), { ariaLabel: 'From' }), to => this.#edit(side, { kind: 'retarget', line, source: to })),
      '→',
      this.#changed(Object.assign(chosen(all, target), { ariaLabel: 'To' }), to => this.#edit(side, { kind: 'retarget', line, target: to })),
      field('on', event),
      ...(name === null ? [] : [field('by itself', own)]),
      field('if', this.#changed(make('input', { type: 'text', value: guard ?? '', placeholder: 'no guard', id: 'guard' }), to => this.#edit(side, { kind: 'set-guard', line, guard: to }))),
      button('Delete', () => this.#edit(side, { kind: 'delete-transition', line }), { id: 'delete' }),
      this.#words);
  }

  #form(label, parts, send) {
    this.#what = 'form';
    const form = make('form.fields-row', { ariaLabel: label }, ...parts, make('button.btn.tiny.main', { type: 'submit' }, 'Add'), button('Cancel', () => { this.#what = ''; this.onLeft(); }));
    form.addEventListener('submit', async event => {
      event.preventDefault();
      if (await send()) { this.#what = ''; this.onLeft(); }
    });
    this.say('');
    this.#place.replaceChildren(form, this.#words);
  }

  addState(side) {
    const name = make('input', { type: 'text', required: true, id: 'new-name' });
    const parents = [...new Set((this.#model(side)?.states ?? []).map(one => one.parent).filter(Boolean))];
    const parent = chosen(parents, '', 'nothing');
    this.#form('A new state', [field('New state', name), ...(parents.length ? [field('in', parent)] : [])],
      () => this.#edit(side, { kind: 'add-state', name: name.value.trim(), ...(parent.value ? { parent: parent.value } : {}) }));
    name.focus();
  }

  arrow(side, from, to) {
    const all = names(this.#model(side));
    const source = Object.assign(chosen(all, from ?? all[0]), { id: 'new-source' });
    const target = Object.assign(chosen(all, to ?? all[0]), { id: 'new-target' });
    const event = make('input', { type: 'text', required: true, id: 'new-event' });
    const guard = make('input', { type: 'text', placeholder: 'no guard', id: 'new-guard' });
    const own = box('new-own', false);
    this.#form('A new arrow', [field('From', source), field('to', target), field('on', event), field('if', guard), ...(side === 'original' ? [field('by itself', own)] : [])],
      () => {
        const both = guard.value.trim() ? null : /^(.*?)\s*\[(.*)\]$/.exec(event.value.trim()); // as on a diagram
        const [named, condition] = both ? both.slice(1) : [event.value.trim(), guard.value.trim()];
        return this.#edit(side, { kind: 'add-transition', source: source.value, target: target.value, event: marked(named, own.checked), ...(condition ? { guard: condition } : {}) });
      });
    (from && to ? event : from ? target : source).focus();
  }
}
