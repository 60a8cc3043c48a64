// The text: a real textarea, so that undo, input methods and screen readers work, with line numbers and marks laid over it.
import { $, make } from './dom.js';

const LINE = 21; // pixels, as in studio.css
const SEVERITIES = ['error', 'warning', 'note']; // the worst first
const TONES = { error: 'bad', warning: 'warn', note: 'soft' };

// What a line is made of, by the kind of file: patterns with their classes. Only colours depend on it.
const PARTS = [
  [/\.(mmd|mermaid|md|markdown)$/i, /(?<c>%%.*$)|(?<k>-->|<<\w+>>|^\s*(?:stateDiagram(?:-v2)?|state\b|direction\b|---|```\w*))|(?<=: )(?<e>[^:]*$)/g],
  [/\.(puml|plantuml|iuml|pu|wsd)$/i, /(?<c>^\s*'.*$)|(?<k>-\w*->|<<\w+>>|^\s*@\w+|^\s*state\b)|(?<=: )(?<e>[^:]*$)/g],
  [/\.(scxml|xml|xmi|uml)$/i, /(?<c><!--.*?-->)|(?<k><\/?[\w:.-]+|\/?>)|(?<e>"[^"]*")/g],
  [/\.ya?ml$/i, /(?<c>(?:^|\s)#.*$)|(?<k>^\s*(?:- )?[\w .-]+:(?=\s|$))|(?<e>"[^"]*"|'[^']*')/g],
  [/./, /(?<c>^\s*#.*$)|(?<k>\b(?:always|never|can|implies|device|until|within|after|before|eventually)\b)|(?<e>"[^"]*")/g],
];

function coloured(line, parts) {
  const pieces = [];
  let end = 0;
  for (const found of line.matchAll(parts)) {
    const [kind, text] = Object.entries(found.groups).find(([, value]) => value !== undefined) ?? [];
    if (!text) continue;
    pieces.push(line.slice(end, found.index), make(`span.${kind}`, {}, text));
    end = found.index + text.length;
  }
  return [...pieces, line.slice(end)];
}

export class Editor {
  #lines = $('.lines');
  #frame = $('#code');
  #area = $('#text');
  #told = $('#told');
  #path = '';
  #marks = new Map(); // line -> { severity, messages }
  #shown = [];
  #breaks = '\n'; // as the file has them: a text area knows only this one
  #at = 0;
  onTyped = () => {};
  onLine = () => {};

  constructor() {
    this.#area.addEventListener('input', () => {
      this.#draw();
      this.onTyped(this.#path, this.#area.value.replaceAll('\n', this.#breaks));
      this.#moved(true);
    });
    this.#area.addEventListener('keydown', key => this.#indent(key));
    document.addEventListener('selectionchange', () => { if (document.activeElement === this.#area) this.#moved(false); });
    this.#area.addEventListener('focus', () => this.#moved(true));
  }

  get path() { return this.#path; }

  get line() { return this.#at; }

  // Another file, or another text of this one; the cursor stays where it can.
  show(path, text) {
    const other = path !== this.#path;
    this.#breaks = /\r\n/.test(text) ? '\r\n' : '\n';
    const shown = text.replace(/\r\n?/g, '\n');
    if (!other && shown === this.#area.value) return;
    const { selectionStart, selectionEnd } = this.#area;
    this.#path = path;
    this.#area.setAttribute('aria-label', `Text of ${path}`);
    this.#area.value = shown;
    if (other) {
      this.#marks = new Map();
      this.#shown = [];
      this.#lines.replaceChildren();
      this.#at = 1;
      this.#area.setSelectionRange(0, 0);
      this.#frame.scrollTo(0, 0);
    } else {
      this.#area.setSelectionRange(Math.min(selectionStart, shown.length), Math.min(selectionEnd, shown.length));
    }
    this.#draw();
  }

  // Marks lines: { line, severity, message } of this file.
  mark(marks) {
    this.#marks = new Map();
    for (const { line, severity, message } of marks) {
      const there = this.#marks.get(line);
      this.#marks.set(line, {
        severity: SEVERITIES.find(one => one === there?.severity || one === severity),
        messages: [...(there?.messages ?? []), message],
      });
    }
    this.#shown = [];
    this.#draw();
    this.#tell();
  }

  // Puts the cursor at the end of a line, and shows it.
  go(line, { focus = false } = {}) {
    const lines = this.#area.value.split('\n');
    const wanted = Math.max(1, Math.min(line, lines.length));
    const end = lines.slice(0, wanted).reduce((sum, one) => sum + one.length + 1, -1);
    if (focus) this.#area.focus({ preventScroll: true });
    this.#area.setSelectionRange(end, end);
    this.#lit(wanted);
    this.#reveal(wanted);
  }

  #reveal(line) {
    const top = (line - 1) * LINE;
    const { scrollTop, clientHeight } = this.#frame;
    if (top < scrollTop + LINE || top > scrollTop + clientHeight - 3 * LINE) this.#frame.scrollTop = Math.max(0, top - clientHeight / 2);
  }

  #moved(anyway) {
    const line = this.#area.value.slice(0, this.#area.selectionStart).split('\n').length;
    if (line === this.#at && !anyway) return;
    const same = line === this.#at;
    this.#lit(line);
    if (!same) this.onLine(this.#path, line);
  }

  #lit(line) {
    this.#lines.children[this.#at - 1]?.classList.remove('at');
    this.#at = line;
    this.#lines.children[line - 1]?.classList.add('at');
    this.#tell();
  }

  #tell() { // the mark of the cursor's line, in full
    const mark = this.#marks.get(this.#at);
    const text = mark ? `Line ${this.#at}: ${mark.messages.join(' · ')}` : '';
    if (this.#told.textContent !== text) this.#told.textContent = text;
    this.#told.className = `told ${TONES[mark?.severity] ?? ''}`;
  }

  #indent(key) { // a new line begins as far in as the one before
    if (key.key !== 'Enter' || key.isComposing || key.ctrlKey || key.altKey || key.metaKey) return;
    const before = this.#area.value.slice(0, this.#area.selectionStart);
    const indent = /^[ \t]*/.exec(before.slice(before.lastIndexOf('\n') + 1))[0];
    if (!indent) return;
    key.preventDefault();
    this.#area.setRangeText(`\n${indent}`, this.#area.selectionStart, this.#area.selectionEnd, 'end');
    this.#area.dispatchEvent(new Event('input', { bubbles: true }));
  }

  #draw() { // only lines that are other than before
    const parts = PARTS.find(([name]) => name.test(this.#path))?.[1] ?? PARTS.at(-1)[1];
    const texts = this.#area.value.split('\n');
    while (this.#lines.children.length > texts.length) this.#lines.lastElementChild.remove();
    texts.forEach((text, index) => {
      if (this.#shown[index] === text && this.#lines.children[index]) return;
      const mark = this.#marks.get(index + 1);
      const row = make('div', {}, make('span.no', {}, String(index + 1)), make('span.t', {}, coloured(text, parts)));
      if (mark) row.append(make(`span.says.${TONES[mark.severity]}`, {}, mark.messages[0]));
      row.className = `${mark?.severity ?? ''} ${index + 1 === this.#at ? 'at' : ''}`;
      const there = this.#lines.children[index];
      if (there) there.replaceWith(row);
      else this.#lines.append(row);
    });
    this.#shown = texts;
    const longest = texts.reduce((most, text) => Math.max(most, text.length), 0);
    this.#area.style.minWidth = `${longest + 4}ch`;
  }
}
