// What was found: a list, and counts by severity.
import { $, button, make } from './dom.js';

const WORDS = { error: ['bad', 'Error'], warning: ['warn', 'Warning'], note: ['soft', 'Note'] };

export function pills(findings) {
  const count = severity => findings.filter(one => one.severity === severity).length;
  return [['error', 'bad'], ['warning', 'warn']].filter(([severity]) => count(severity))
    .map(([severity, tone]) => make(`span.pill.${tone}`, { title: `${count(severity)} ${severity}s` }, String(count(severity))));
}

// One finding, with what one can do: go to its line, or see the run that shows it.
export function entry(finding, { go, play }) {
  const [tone, word] = WORDS[finding.severity] ?? WORDS.note;
  return make(`article.finding.${finding.severity}`, {},
    make('b', {}, make(`span.${tone}`, {}, word), ` · ${finding.message}`),
    ...(finding.why ? [make('span', {}, finding.why)] : []),
    make('span.do', {},
      ...(finding.run?.length ? [button('Play it', () => play(finding.run))] : []),
      button(`${finding.path.split('/').at(-1)}, line ${finding.line}`, () => go(finding.path, finding.line))));
}

export class Findings {
  #place = $('#findings');

  show(findings, actions, unchecked) {
    $('#counts').replaceChildren(...pills(findings));
    $('#views [data-show="findings"]').classList.toggle('bad', findings.some(one => one.severity === 'error'));
    this.#place.replaceChildren(...(unchecked ? [make('p.banner', {}, make('span', {}, unchecked))] : []),
      ...(findings.length || unchecked ? findings.map(one => entry(one, actions)) : [make('p.soft.small', {}, 'Nothing found.')]));
  }
}
