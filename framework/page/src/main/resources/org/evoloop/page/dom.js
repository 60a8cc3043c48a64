// Small helpers for the page's modules.
export const $ = id => document.getElementById(id);

export function element(name, text = '', className = '') {
  const made = document.createElement(name);
  made.textContent = text;
  if (className) made.className = className;
  return made;
}

// An element with what is in it, texts or elements.
export function holding(name, className, ...content) {
  const made = element(name, '', className);
  made.append(...content);
  return made;
}

// A state as a box; a long name is broken at its capitals.
export function state(name, ...classes) {
  const made = element('span', '', ['st', ...classes].join(' '));
  made.append(...name.split(/(?<=[a-z])(?=[A-Z])/).flatMap((part, index) => (index ? [document.createElement('wbr'), part] : [part])));
  return made;
}

// Sets a text only if it has changed: a screen reader tells what has changed, and nothing else.
export function say(place, text) {
  if (place.textContent !== text) place.textContent = text;
}

// Renews what is in a place only if its key has changed.
export function renew(place, key, make) {
  const text = JSON.stringify(key);
  if (place.shownFor === text) return;
  place.shownFor = text;
  place.replaceChildren(...make());
}

// A list of terms, without those that have no text.
export function rows(place, pairs) {
  const shown = pairs.filter(([, text]) => text !== '' && text !== null && text !== undefined);
  renew(place, shown, () => shown.flatMap(([term, text, className]) => [element('dt', term), element('dd', text, className)]));
}

export const plural = (count, what) => `${count} ${what}${count === 1 ? '' : 's'}`;

// Made once: a format costs far more to make than to use.
const TIME = new Intl.DateTimeFormat([], { hourCycle: 'h23', hour: '2-digit', minute: '2-digit', second: '2-digit' });

export const clock = at => TIME.format(new Date(at));

export function took(nanos) {
  if (nanos < 999_500) return `${(nanos / 1e3).toPrecision(3)} µs`;
  return nanos < 999_500_000 ? `${(nanos / 1e6).toPrecision(3)} ms` : `${(nanos / 1e9).toPrecision(3)} s`;
}

// Time that is left: below ten seconds with tenths.
export function left(millis, whole) {
  const seconds = Math.max(0, millis) / 1000;
  if (whole < 10_000) return `${seconds.toFixed(1)} s`;
  const all = Math.ceil(seconds - 0.05);
  const minutes = Math.floor(all / 60);
  const tail = `${String(all % 60).padStart(2, '0')}`;
  return minutes < 60 ? `${minutes}:${tail}` : `${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, '0')}:${tail}`;
}

// The time of a timer in words: tm(10min) is after 10 min.
export const inWords = event => event.replace(/^tm\((\d+)([a-z]+)\)$/, 'after $1 $2');
