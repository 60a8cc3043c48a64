const token = new URLSearchParams(location.hash.slice(1)).get('token');
if (token) {
  history.replaceState(null, '', '/');
  await fetch('/session', { method: 'POST', body: token });
}
const { files } = await (await fetch('/api/files')).json();
for (const file of files) {
  const item = document.createElement('li');
  item.textContent = `${file.path} ${file.machines.join(', ')}`;
  document.getElementById('files').append(item);
}
