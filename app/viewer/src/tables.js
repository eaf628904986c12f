// Text of the page: numbers, tables, lists.

export function element(tag, text, className) {
  const node = document.createElement(tag);
  if (text !== undefined) node.textContent = text;
  if (className) node.className = className;
  return node;
}

export function numberText(value, digits = 4) {
  if (typeof value !== "number") return String(value);
  if (Number.isInteger(value)) return value.toLocaleString("en-US").replace("-", "\u2212");
  return String(Number(value.toPrecision(digits))).replace("-", "\u2212");
}

function barCell(value, largest) {
  const cell = element("td", numberText(value, 3), "number bar");
  cell.style.setProperty("--share", `${largest > 0 ? 100 * value / largest : 0}%`);
  return cell;
}

export function tableOf({title, columns, rows, bars}) {
  const section = element("section");
  section.append(element("h2", title));
  const table = element("table");
  const last = columns.length - 1;
  const largest = Math.max(0, ...rows.map(row => row.cells[last]).filter(Number.isFinite));
  const numeric = columns.map((_, i) => rows.some(row => typeof row.cells[i] === "number"));
  if (columns.some(column => column !== "")) {
    const head = element("tr");
    columns.forEach((column, i) => head.append(element("th", column, numeric[i] ? "number" : "")));
    table.append(head);
  }
  for (const row of rows) {
    const line = element("tr");
    row.cells.forEach((cell, i) => {
      const text = typeof cell === "string" ? cell.replaceAll("_", " ") : numberText(cell);
      line.append(bars && i === last ? barCell(cell, largest) : element("td", text, numeric[i] ? "number" : ""));
    });
    table.append(line);
  }
  section.append(table);
  return section;
}

export function fillText(report) {
  document.title = report.title;
  const at = id => document.getElementById(id);
  at("title").textContent = report.title;
  at("subtitle").textContent = report.subtitle;
  for (const verdict of report.verdicts) {
    at("verdicts").append(element("li", verdict, /^(open|not )/.test(verdict) ? "bad" : ""));
  }
  for (const warning of report.warnings) at("warnings").append(element("li", warning));
  for (const table of report.tables) at("tables").append(tableOf(table));
  for (const paper of report.papers) at("papers").append(element("li", paper));
  at("json").textContent = JSON.stringify(report.json, null, 2);
}
