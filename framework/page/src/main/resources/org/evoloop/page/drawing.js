// A drawing of a state machine in a window of the page. One can drag and enlarge it, and light what is in it.
//
// The SVG has no colours: style.css gives them by class. A state is a .state with data-state, a .box and a .name; an arrow is a
// .transition with data-source and data-target, and one .event for each text, with data-event, too. A text's data-line (its line in
// the file) and data-id are only passed on. What is lit gets a class: now, doubt, was, held (states); taken, plan, may (arrows); wrong,
// warned (both).
export const LEGIBLE = 0.77; // 13 px of the drawing as 10 px on the screen
const LARGEST = 1.1;
const SVG = 'http://www.w3.org/2000/svg';

const all = (selector, where) => [...where.querySelectorAll(selector)];

function made(name, attributes) {
  const one = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) one.setAttribute(key, value);
  return one;
}

// The arrow heads for all drawings of a document: a marker takes its colour from the sheet, not from its line.
function arrowHeads() {
  if (document.getElementById('arrow')) return;
  const heads = made('svg', { class: 'arrows', 'aria-hidden': 'true' });
  for (const id of ['arrow', 'arrow-may', 'arrow-new', 'arrow-way']) {
    const head = made('marker', {
      id, viewBox: '0 0 10 10', refX: 9, refY: 5, markerWidth: 10, markerHeight: 10, markerUnits: 'userSpaceOnUse', orient: 'auto',
    });
    head.append(made('path', { d: 'M0 1 L9 5 L0 9' }));
    heads.append(head);
  }
  document.body.prepend(heads);
}

export class Drawing {
  #place;
  #svg = null;
  #whole = [1, 1];
  #size = [1, 1]; // of the window, in pixels
  #scale = 1;
  #centre = [0, 0];
  #focus = null; // the state that is kept in view
  #moved = false; // by hand, so that nothing else moves it
  #picked = () => {};
  #mini = made('svg', { class: 'mini', 'aria-hidden': 'true' }); // all of it, small, with the window

  // place: an element of class "port". Buttons with data-zoom (in, out, fit, now) in the same .view belong to it. most: the height
  // in pixels up to which it grows with the drawing; without it, the page decides on the height.
  constructor(place, { most = 0 } = {}) {
    arrowHeads();
    this.#place = place;
    this.most = most;
    place.tabIndex = 0;
    new ResizeObserver(() => {
      this.#measure();
      this.#settle();
    }).observe(place);
    place.addEventListener('pointerdown', down => this.#drag(down));
    place.addEventListener('wheel', wheel => {
      if (!wheel.ctrlKey) return; // the page scrolls as usual
      wheel.preventDefault();
      this.zoom(wheel.deltaY < 0 ? 1.15 : 1 / 1.15);
    }, { passive: false });
    place.addEventListener('keydown', key => this.#key(key));
    place.addEventListener('click', click => {
      const found = click.target.closest('.state, .event, .transition');
      if (found && this.#svg?.contains(found)) this.#picked(found.dataset, click);
    });
    place.closest('.view')?.querySelector('.zoom')?.before(this.#mini);
    this.#mini.addEventListener('pointerdown', down => this.#jump(down));
    this.#mini.classList.add('all');
    for (const button of all('[data-zoom]', place.closest('.view') ?? place)) {
      button.addEventListener('click', () => this[{ in: 'larger', out: 'smaller', fit: 'fit', now: 'reset' }[button.dataset.zoom]]());
    }
  }

  // The SVG element, or null.
  get svg() { return this.#svg; }

  // The whole drawing's width; undefined if there is none.
  get width() { return this.#svg ? this.#whole[0] : undefined; }

  // Calls back with the dataset of a state or arrow that is clicked.
  onPick(picked) { this.#picked = picked; }

  // Puts an SVG, a text or an element, in the place of the one before. With keep, the window stays where it is.
  show(svg, { keep = false } = {}) {
    const drawn = typeof svg === 'string'
      ? document.importNode(new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement, true) : svg;
    const box = (drawn.getAttribute('viewBox') ?? `0 0 ${drawn.getAttribute('width')} ${drawn.getAttribute('height')}`).split(/[ ,]+/).map(Number);
    drawn.classList.add('chart');
    for (const line of all('.transition .line', drawn)) { // an arrow is as wide to the pointer as a finger needs
      const hit = line.cloneNode();
      hit.setAttribute('class', 'hit');
      line.before(hit);
    }
    for (const name of ['width', 'height']) drawn.removeAttribute(name);
    this.#svg?.remove();
    this.#svg = drawn;
    this.#whole = [box[2], box[3]];
    this.#place.append(drawn);
    this.#outline();
    if (keep && this.#moved) this.#at(...this.#centre);
    else this.reset();
  }

  clear() {
    this.#svg?.remove();
    this.#svg = null;
    this.#mini.classList.add('all');
  }

  // The states without their names, and where the window is.
  #outline() {
    const boxes = all('.composite > .box, .state > .box', this.#svg).map(drawn => {
      const box = drawn.cloneNode();
      box.classList.toggle('added', drawn.parentNode.classList.contains('added'));
      box.dataset.of = drawn.parentNode.dataset.state ?? '';
      return box;
    });
    this.#mini.setAttribute('viewBox', `0 0 ${this.#whole.join(' ')}`);
    this.#mini.replaceChildren(...boxes, made('rect', { class: 'win' }));
  }

  #jump(down) { // to where it is pressed, and on while it is dragged
    if (down.button > 0) return;
    down.preventDefault();
    this.#mini.setPointerCapture(down.pointerId);
    const move = event => {
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.#mini.getScreenCTM().inverse());
      this.#moved = true;
      this.#at(x, y);
    };
    move(down);
    this.#mini.onpointermove = move;
    this.#mini.onlostpointercapture = () => { this.#mini.onpointermove = null; };
  }

  // Marks the states of these names with a class, and no others. The first becomes what is kept in view if the class is now or doubt.
  mark(tone, names) {
    if (!this.#svg) return;
    const wanted = new Set(names);
    for (const one of all('.state', this.#svg)) one.classList.toggle(tone, wanted.has(one.dataset.state));
    for (const one of all('.box', this.#mini)) one.classList.toggle(tone, wanted.has(one.dataset.of));
    for (const frame of all('.frame', this.#svg)) frame.classList.toggle('in', all('.state.now', frame.parentNode).length > 0);
    if ((tone === 'now' || tone === 'doubt') && names.length) this.#keepInView(names[0]);
  }

  // Marks arrows with a class, and no others: steps are {source, target, event} or {id}. With numbered, each gets its number.
  light(tone, steps, { numbered = false } = {}) {
    if (!this.#svg) return;
    for (const one of all(`.transition.${tone}, .event.${tone}`, this.#svg)) one.classList.remove(tone);
    if (numbered) all('.step', this.#svg).forEach(one => one.remove());
    steps.forEach((step, index) => {
      const found = this.arrows(step);
      for (const one of found) one.classList.add(tone);
      const text = found.find(one => one.matches('.event'))?.querySelector('text');
      if (numbered && text) text.parentNode.parentNode.append(this.#number(text, index + 1));
    });
  }

  #number(text, number) {
    const box = text.getBBox();
    const [x, y] = [box.x - 13, box.y + box.height / 2];
    const mark = made('g', { class: 'step' });
    const label = made('text', { x, y: y + 4.3 });
    label.textContent = number;
    mark.append(made('circle', { r: 9, cx: x, cy: y }), label);
    return mark;
  }

  // The drawn parts of a step: its line and its text.
  arrows({ source, target, event, id }) {
    if (!this.#svg) return [];
    if (id !== undefined) return all('.transition, .event', this.#svg).filter(one => one.dataset.id?.split(' ').includes(String(id)));
    return all('.transition, .event', this.#svg).filter(({ dataset }) => dataset.source === source && dataset.target === target
      && (dataset.event === undefined || event === undefined || dataset.event.split(', ').includes(event)));
  }

  // Moves the window to a state, a step, or an element of the drawing.
  panTo(what) {
    const found = what instanceof Element ? what : typeof what === 'string' ? this.#state(what) : this.arrows(what).at(-1);
    if (!found) return;
    this.#at(...this.#middle(found));
  }

  reset() { // all of it if that can be read, else what matters
    this.#moved = false;
    this.#settle();
  }

  fit() {
    this.#moved = true;
    this.#scale = Math.min(LARGEST, this.#fitting());
    this.#at(this.#whole[0] / 2, this.#whole[1] / 2);
  }

  larger() { this.zoom(1.25); }

  smaller() { this.zoom(0.8); }

  zoom(by) {
    this.#moved = true;
    this.#scale = Math.min(2, Math.max(this.#fitting(), this.#scale * by));
    this.#at(...this.#centre);
  }

  #state(name) { return all('.state', this.#svg).find(one => one.dataset.state === name); }

  #middle(element) {
    const box = element.getBBox();
    return [box.x + box.width / 2, box.y + box.height / 2];
  }

  #keepInView(name) {
    if (this.#focus === name) return;
    this.#focus = name;
    this.#settle();
  }

  // Asked for only if it has changed, since the browser would have to lay out a new drawing before it answers.
  #measure() { this.#size = [this.#place.clientWidth || 1, this.#place.clientHeight || 1]; }

  #fitting() { return Math.min(this.#size[0] / this.#whole[0], this.#size[1] / this.#whole[1]); }

  #settle() {
    if (!this.#svg) return;
    if (this.most) {
      const scale = Math.min(LARGEST, Math.max(LEGIBLE, this.#size[0] / this.#whole[0]));
      const height = `${Math.min(this.most, Math.max(140, Math.ceil(this.#whole[1] * scale) + 8))}px`;
      if (this.#place.style.height !== height) {
        this.#place.style.height = height;
        this.#measure();
      }
    }
    if (this.#moved) {
      this.#at(...this.#centre);
      return;
    }
    this.#scale = Math.min(LARGEST, Math.max(this.#fitting(), LEGIBLE));
    const focus = this.#focus ? this.#state(this.#focus) : this.#svg.querySelector('.pseudostate'); // where it begins
    this.#at(...(focus ? this.#middle(focus) : this.#whole.map(one => one / 2)));
  }

  #at(x, y) {
    if (!this.#svg) return;
    const seen = this.#size.map(one => one / this.#scale);
    this.#centre = [x, y].map((at, axis) => (seen[axis] >= this.#whole[axis] ? this.#whole[axis] / 2
      : Math.min(this.#whole[axis] - seen[axis] / 2, Math.max(seen[axis] / 2, at))));
    const from = this.#centre.map((at, axis) => at - seen[axis] / 2);
    this.#svg.setAttribute('viewBox', [...from, ...seen].map(one => one.toFixed(1)).join(' '));
    const more = (name, yes) => this.#place.style.setProperty(name, yes ? '28px' : '0px'); // there, the edge fades
    more('--l', from[0] > 8);
    more('--r', from[0] + seen[0] < this.#whole[0] - 8);
    more('--u', from[1] > 8);
    more('--d', from[1] + seen[1] < this.#whole[1] - 8);
    const inside = from.every((at, axis) => at <= 8 && at + seen[axis] >= this.#whole[axis] - 8);
    this.#mini.classList.toggle('all', inside); // its place stays, so that no control moves
    const win = this.#mini.lastElementChild;
    const low = from.map(at => Math.max(0, at));
    const high = from.map((at, axis) => Math.min(this.#whole[axis], at + seen[axis]));
    for (const [name, value] of Object.entries({ x: low[0], y: low[1], width: high[0] - low[0], height: high[1] - low[1] })) win.setAttribute(name, value.toFixed(1));
  }

  #drag(down) {
    if (down.button > 0 || !down.isPrimary || !this.#svg) return;
    const [x, y] = [down.clientX, down.clientY];
    const centre = this.#centre;
    const move = now => {
      if (Math.hypot(now.clientX - x, now.clientY - y) < 4) return; // still a click
      this.#moved = true;
      this.#place.classList.add('drag');
      this.#at(centre[0] - (now.clientX - x) / this.#scale, centre[1] - (now.clientY - y) / this.#scale);
    };
    const up = () => {
      this.#place.classList.remove('drag');
      for (const end of ['pointerup', 'pointercancel']) removeEventListener(end, up);
      removeEventListener('pointermove', move);
    };
    addEventListener('pointermove', move);
    for (const end of ['pointerup', 'pointercancel']) addEventListener(end, up);
  }

  #key(key) {
    if (key.target !== this.#place || key.ctrlKey || key.altKey || key.metaKey) return;
    const step = 60 / this.#scale;
    const way = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] }[key.key];
    if (way) {
      this.#moved = true;
      this.#at(this.#centre[0] + way[0], this.#centre[1] + way[1]);
    } else if (key.key === '+' || key.key === '=') {
      this.larger();
    } else if (key.key === '-') {
      this.smaller();
    } else if (key.key === '0') {
      this.reset();
    } else {
      return;
    }
    key.preventDefault();
  }
}
