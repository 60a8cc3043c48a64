// Both machines as drawings: what is picked, lit and found in them, and the arrow that is drawn from a picked state's ring.
import { Drawing } from '/drawing.js';
import { $, $$, make } from './dom.js';

const SVG = 'http://www.w3.org/2000/svg';
const SIDES = ['new', 'original'];

export class Pictures {
  #drawings = {};
  #models = {}; // the last good ones
  #notes = {};
  #seen = ''; // what was brought into view last
  #looking = 0; // the next frame, in which it is known where everything is
  #whole = {}; // which of them are kept as large as fits
  onPick = () => {};
  onArrow = () => {};

  constructor() {
    for (const side of SIDES) {
      const view = $(`.view[data-side="${side}"]`);
      const drawing = new Drawing($('.port', view));
      drawing.onPick(data => this.#picked(side, data));
      this.#drawings[side] = drawing;
      this.#notes[side] = make('p.note', { role: 'status', hidden: true });
      $('figcaption', view).after(this.#notes[side]);
      $('.port', view).addEventListener('keydown', key => this.#step(side, key));
      for (const zoom of $$('[data-zoom]', view)) zoom.addEventListener('click', () => { this.#whole[side] = zoom.dataset.zoom === 'fit'; });
    }
    $('.view[data-side="new"] .port').addEventListener('pointerdown', down => this.#pull(down, 'new'), { capture: true });
    $('.view[data-side="original"] .port').addEventListener('pointerdown', down => this.#pull(down, 'original'), { capture: true });
  }

  model(side) { return this.#models[side]; }

  // Where most arrows lead: as the place is shaped, until one asks for the other way.
  get direction() {
    const { clientWidth, clientHeight } = $('.view[data-side="new"] .port');
    return clientHeight > clientWidth * 1.2 ? 'down' : 'right';
  }

  // An answer of /api/draw. A model with a mistake keeps its last good picture.
  show(answer, keep = true) {
    for (const side of SIDES) {
      const model = answer[side];
      if (!model) continue;
      const { mistake } = model;
      $(`.view[data-side="${side}"]`).classList.toggle('stale', Boolean(mistake));
      this.#say(side, mistake ? `Line ${mistake.line}: ${mistake.message} ${this.#models[side] ? 'The picture shows the text as it was before.' : ''}` : model.tooLarge);
      if (mistake) continue;
      const before = this.#models[side]?.svg;
      this.#models[side] = model;
      if (!model.svg) this.#drawings[side].clear();
      else if (model.svg !== before) {
        this.#drawings[side].show(model.svg, { keep });
        this.#seen = '';
      }
      if (model.svg && this.#whole[side]) this.#drawings[side].fit();
    }
  }

  forget(side) {
    delete this.#models[side];
    this.#drawings[side].clear();
    this.#say(side, null);
  }

  #say(side, text) {
    this.#notes[side].hidden = !text;
    this.#notes[side].textContent = text ?? '';
  }

  // The element that a line is about: a transition before a state.
  on(path, line) {
    for (const side of SIDES) {
      const model = this.#models[side];
      if (model?.path !== path) continue;
      const transition = model.transitions.find(one => one.line === line && !one.initial);
      if (transition) return { side, transition };
      const state = model.states.find(one => one.line === line);
      if (state) return { side, state };
    }
    return null;
  }

  state(side, name) { return this.#models[side]?.states.find(one => one.name === name); }

  // Lights what is picked, its plan through the original, where the try is, and what was found.
  light({ picked, plan, now, findings }) {
    for (const side of SIDES) {
      const drawing = this.#drawings[side];
      if (!drawing.svg) continue;
      const mine = picked?.side === side ? picked : null;
      drawing.light('taken', mine?.transition ? [{ id: mine.transition.id }] : []);
      drawing.mark('picked', mine?.state ? [mine.state.name] : []);
      drawing.light('plan', side === 'original' ? plan : [], { numbered: side === 'original' });
      drawing.mark('now', now?.[side] ? [now[side]] : []);
      for (const [tone, severity] of [['wrong', 'error'], ['warned', 'warning']]) {
        const found = findings.filter(one => one.machine === side && one.severity === severity);
        drawing.mark(tone, found.filter(one => one.state).map(one => one.state));
        drawing.light(tone, found.filter(one => one.transition).map(one => ({ id: one.transition })));
      }
      this.#ring(side, mine?.state);
    }
    const drawing = this.#drawings[picked?.side];
    const what = `${picked?.side} ${picked?.state?.name ?? picked?.transition?.id}`;
    if (!drawing?.svg || what === this.#seen) return; // it may have been moved away by hand
    this.#seen = what;
    cancelAnimationFrame(this.#looking);
    this.#looking = requestAnimationFrame(() => this.#see(drawing, picked));
  }

  #see(drawing, { transition, state }) { // moves only if it is outside
    const found = state ? $$('.state', drawing.svg).find(one => one.dataset.state === state.name) : drawing.arrows({ id: transition.id }).at(-1);
    if (!found) return;
    const [box, port] = [found.getBoundingClientRect(), drawing.svg.getBoundingClientRect()];
    const inside = box.left >= port.left && box.right <= port.right && box.top >= port.top && box.bottom <= port.bottom;
    if (!inside && !(box.width > port.width)) drawing.panTo(found);
  }

  #picked(side, data) {
    const model = this.#models[side];
    if (data.state !== undefined) {
      const state = model.states.find(one => one.name === data.state);
      if (state) this.onPick({ side, state });
      return;
    }
    const ids = (data.id ?? '').split(' ').filter(Boolean); // a joined arrow: each click takes the next one
    const last = ids.indexOf(this.lastId);
    this.lastId = ids[(last + 1) % ids.length];
    const transition = model.transitions.find(one => one.id === this.lastId);
    if (transition) this.onPick({ side, transition });
  }

  // N and P: the next and the previous state or arrow.
  #step(side, key) {
    const way = { n: 1, p: -1 }[key.key.toLowerCase()];
    const model = this.#models[side];
    if (!way || !model || key.ctrlKey || key.altKey || key.metaKey) return;
    const every = [...model.states.map(state => ({ side, state })), ...model.transitions.filter(one => !one.initial).map(transition => ({ side, transition }))];
    if (!every.length) return;
    const index = every.findIndex(one => (one.state && one.state.name === this.here?.state?.name) || (one.transition && one.transition.id === this.here?.transition?.id));
    this.onPick(every[(Math.max(index, way < 0 ? 0 : -1) + way + every.length) % every.length]);
    key.preventDefault();
  }

  #ring(side, state) {
    const { svg } = this.#drawings[side];
    $$('.handle', svg).forEach(one => one.remove());
    if (!state) return;
    const element = $$('.state', svg).find(one => one.dataset.state === state.name);
    const box = element && $('.box', element)?.getBBox();
    if (!box) return;
    const ring = document.createElementNS(SVG, 'circle');
    for (const [name, value] of Object.entries({ class: 'handle', r: 7, cx: box.x + box.width, cy: box.y + box.height / 2 })) ring.setAttribute(name, value);
    svg.append(ring);
    ring.dataset.from = state.name;
  }

  // From the ring to another state, or back to its own.
  #pull(down, side) {
    const ring = down.target.closest('.handle');
    if (!ring || down.button > 0) return;
    down.stopPropagation(); // the picture stays where it is
    down.preventDefault();
    const { svg } = this.#drawings[side];
    const line = document.createElementNS(SVG, 'path');
    line.setAttribute('class', 'pulled');
    svg.append(line);
    const [x, y] = [ring.cx.baseVal.value, ring.cy.baseVal.value];
    const over = event => document.elementFromPoint(event.clientX, event.clientY)?.closest('.state');
    const move = event => {
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      line.setAttribute('d', `M${x} ${y} L${at.x} ${at.y}`);
      const target = over(event);
      $$('.aimed', svg).forEach(one => one.classList.toggle('aimed', one === target));
      target?.classList.add('aimed');
    };
    const end = event => {
      removeEventListener('pointermove', move);
      for (const name of ['pointerup', 'pointercancel']) removeEventListener(name, end);
      line.remove();
      $$('.aimed', svg).forEach(one => one.classList.remove('aimed'));
      const target = event.type === 'pointerup' && over(event);
      if (target && svg.contains(target)) this.onArrow(side, ring.dataset.from, target.dataset.state);
    };
    addEventListener('pointermove', move);
    for (const name of ['pointerup', 'pointercancel']) addEventListener(name, end);
  }
}
