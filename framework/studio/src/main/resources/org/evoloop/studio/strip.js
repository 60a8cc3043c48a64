// What is picked, with its fields. Each field is an edit of the text.
import { $, button, make } from './dom.js';

const field = (label, input) => make('label', {}, label, input);
const chosen = (names, value, first) => {
  const select = make('select', {}, ...(first ? [make('option', { value: '' }, first)] : []), ...names.map(name => make('option', { value: name }, name)));
  select.value = names.includes(value) ? value : '';
  return select;
};
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
    this.#place.replaceChildren(
      this.#changed(Object.assign(chosen(all, source), { ariaLabel: 'From' }), to => this.#edit(side, { kind: 'retarget', line, source: to })),
      '→',
      this.#changed(Object.assign(chosen(all, target), { ariaLabel: 'To' }), to => this.#edit(side, { kind: 'retarget', line, target: to })),
      field('on', this.#changed(make('input', { type: 'text', value: trigger, id: 'trigger' }), to => this.#edit(side, { kind: 'set-trigger', line, event: to }))),
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
    this.#form('A new arrow', [field('From', source), field('to', target), field('on', event), field('if', guard)],
      () => {
        const both = guard.value.trim() ? null : /^(.*?)\s*\[(.*)\]$/.exec(event.value.trim()); // as on a diagram
        const [named, condition] = both ? both.slice(1) : [event.value.trim(), guard.value.trim()];
        return this.#edit(side, { kind: 'add-transition', source: source.value, target: target.value, event: named, ...(condition ? { guard: condition } : {}) });
      });
    (from && to ? event : from ? target : source).focus();
  }
}
