// Elements, made in one expression.

export const $ = (selector, where = document) => where.querySelector(selector);
export const $$ = (selector, where = document) => [...where.querySelectorAll(selector)];

// make('button.btn', { onclick }, 'text', child): texts are text, never HTML.
export function make(what, properties = {}, ...children) {
  const [tag, ...classes] = what.split('.');
  const one = document.createElement(tag);
  if (classes.length) one.className = classes.join(' ');
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('on') || name in one) one[name] = value;
    else if (value !== null && value !== undefined) one.setAttribute(name, value);
  }
  one.append(...children.flat().filter(child => child !== null && child !== undefined));
  return one;
}

export const button = (text, onclick, properties = {}) => make('button.btn.tiny', { type: 'button', onclick, ...properties }, text);

// A dialog with a title, a body and a footer; Escape and ✕ close it, and the focus returns.
export function showDialog(title, body, footer = []) {
  const dialog = $('#dialog');
  const close = button('✕', () => dialog.close(), { ariaLabel: 'Close' });
  close.classList.add('quiet', 'icon');
  dialog.replaceChildren(
    make('header', {}, make('h2', { id: 'dialog-title' }, title), close),
    make('div.body', {}, body),
    ...(footer.length ? [make('footer', {}, footer)] : []));
  if (!dialog.open) dialog.showModal();
  return dialog;
}
