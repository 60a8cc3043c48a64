// Properties: one is written, and it is proved, or the run that refutes it is played in the pictures.
import { $, button, make } from './dom.js';
import { ask } from './server.js';

export class Properties {
  #place = $('#properties');
  #judged = []; // { text, holds, decided, words, run, error }
  #list = make('div.findings');
  #field = make('input.mono', { type: 'text', placeholder: 'Name: always can Off', id: 'property' });
  #pair;
  #actions;
  #written = [];
  #number = 0;

  // actions: { go(path, line), play(run), keep(text) -> a promise }.
  constructor(pair, actions) {
    this.#pair = pair;
    this.#actions = actions;
    const form = make('form.fields-row', { ariaLabel: 'A new property' }, make('label.small.soft', {}, 'New property', this.#field), make('button.btn.tiny.main', { type: 'submit' }, 'Is it so?'));
    form.addEventListener('submit', event => {
      event.preventDefault();
      const text = this.#field.value.trim();
      if (!text) return;
      this.#judged = [{ text }, ...this.#judged.filter(one => one.text !== text)];
      this.refresh();
    });
    this.#place.append(form, this.#list);
    this.#show();
  }

  // What /api/check has found, and the file of properties beside the new model, if there is one.
  found(findings, path, text) {
    const broken = findings.some(one => one.path === path && one.rule !== 'property');
    this.#written = text.split('\n').map((line, index) => [line.trim(), index + 1]).filter(([line]) => line && !line.startsWith('#')).map(([line, number]) => {
      const finding = findings.find(one => one.rule === 'property' && one.message.includes(`line ${number})`));
      return { line, path, number, finding, proved: !finding && !broken };
    });
    this.#show();
  }

  // All that were asked for are judged again, as the models are other ones now.
  async refresh() {
    const mine = ++this.#number;
    const pair = this.#pair();
    if (!pair) return;
    for (const one of this.#judged) {
      try {
        const answer = await ask('POST', '/api/property', { pair, property: one.text });
        if (mine !== this.#number) return;
        Object.assign(one, { error: answer.mistake?.message ?? '' }, answer);
      } catch (failure) {
        if (mine !== this.#number || failure.status === 0) return;
        one.error = failure.message;
      }
      this.#show();
    }
  }

  #show() {
    const written = this.#written.map(({ line, path, number, finding, proved }) => make(`article.finding.${proved ? 'proved' : finding ? 'error' : 'warning'}`, {},
      make('b', {}, make(`span.${proved ? 'good' : finding ? 'bad' : 'warn'}`, {}, proved ? 'Proved' : finding ? 'Does not hold' : 'Not decided'), ` · ${line}`),
      ...(finding?.why ? [make('span', {}, finding.why)] : []),
      make('span.do', {}, ...(finding?.run?.length ? [button('Play it', () => this.#actions.play(finding.run))] : []), button(`${path}, line ${number}`, () => this.#actions.go(path, number)))));
    this.#list.replaceChildren(...this.#judged.map(one => this.#entry(one)), ...written,
      ...(this.#judged.length || written.length ? [] : [make('p.soft.small', {}, 'What must always hold, such as “the lamp goes off: always can Off”. It is proved for every run, or a run that refutes it is shown.')]));
  }

  #entry(one) {
    const [kind, tone, word] = one.error ? ['warning', 'warn', 'Not understood'] : one.holds === undefined ? ['plain', 'soft', 'Asking …']
      : one.decided === false ? ['warning', 'warn', 'Not decided'] : one.holds ? ['proved', 'good', 'Proved'] : ['error', 'bad', 'Does not hold'];
    return make(`article.finding.${kind}`, {},
      make('b', {}, make(`span.${tone}`, {}, word), ' · ', make('code', {}, one.text)),
      make('span', {}, one.error || one.words || ''),
      make('span.do', {},
        ...(one.run?.length ? [button('Play it', () => this.#actions.play(one.run))] : []),
        ...(one.error ? [] : [button('Keep it', () => this.#actions.keep(one.text))]),
        button('Forget it', () => { this.#judged = this.#judged.filter(other => other !== one); this.#show(); })));
  }
}
