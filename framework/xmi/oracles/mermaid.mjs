// Tells how Mermaid itself understands state diagrams: the file has several, each before a line ====. For each of them, in order,
// prints a line for each state, "state ID PARENT", and each transition, "edge SOURCE TARGET : LABEL", and then a line ====. If
// Mermaid refuses the diagram, the first line of its message is printed, "refused MESSAGE".
import fs from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const installed = createRequire(process.argv[2] + "/");
const load = async (name) => import(pathToFileURL(installed.resolve(name)).href);
const { JSDOM } = installed("jsdom");
const page = new JSDOM("<!DOCTYPE html><body></body>").window;
Object.assign(globalThis, { window: page, document: page.document });
const { default: mermaid } = await load("mermaid/dist/mermaid.core.mjs");
mermaid.initialize({ startOnLoad: false });

// Mermaid keeps #44; as a mark until it draws.
const named = { quot: '"', lt: "<", gt: ">", amp: "&" };
const decoded = (text) =>
  (text ?? "")
    .replace(/ﬂ°°(\d+)¶ß/g, (_, code) => String.fromCodePoint(Number(code)))
    .replace(/ﬂ°(\w+)¶ß/g, (_, name) => named[name])
    .replace(/&(\w+);/g, (_, name) => named[name]);
const end = (id) => (/_(start|end)$/.test(id) ? "[*]" : id);

const lines = [];
for (const text of fs.readFileSync(process.argv[3], "utf8").split("====\n").slice(0, -1)) {
  let data;
  try {
    data = (await mermaid.mermaidAPI.getDiagramFromText(text)).db.getData();
  } catch (refusal) {
    lines.push(`refused ${refusal.message.split("\n")[0]}`, "====");
    continue;
  }
  const nodes = new Map(data.nodes.map((node) => [node.id, node]));
  const isDivider = (id) => nodes.get(id)?.shape === "divider";
  for (const node of data.nodes) {
    let parent = node.parentId;
    while (isDivider(parent)) parent = nodes.get(parent).parentId;
    if (!isDivider(node.id) && end(node.id) !== "[*]") lines.push(`state ${node.id} ${parent ?? "-"}`);
  }
  for (const edge of data.edges) lines.push(`edge ${end(edge.start)} ${end(edge.end)} : ${decoded(edge.label)}`.trim());
  lines.push("====");
}
fs.writeFileSync(process.argv[4], lines.join("\n") + "\n");
