// The extension for Visual Studio Code: it starts "hysteron lsp", and runs "hysteron" as a task for the lenses.
"use strict";

const fs = require("fs");
const path = require("path");
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

/** The program: that of the settings, or one that the extension brings along. */
function program(context) {
  const own = path.join(context.extensionPath, "bin", process.platform === "win32" ? "hysteron.exe" : "hysteron");
  const settings = vscode.workspace.getConfiguration("hysteron");
  const given = settings.inspect("path");
  const isGiven = given && (given.globalValue || given.workspaceValue);
  return !isGiven && fs.existsSync(own) ? own : settings.get("path");
}

async function start(context) {
  const settings = vscode.workspace.getConfiguration("hysteron");
  const options = {
    timeLimit: settings.get("timeLimit"),
    compat: settings.get("compat"),
    lenses: settings.get("lenses"),
  };
  const toml = (pattern) => ({ scheme: "file", pattern });
  client = new LanguageClient(
    "hysteron",
    "hysteron",
    { command: program(context), args: ["lsp", "--stdio"] },
    {
      documentSelector: [{ language: "tcl" }, { language: "python", scheme: "file" }, toml("**/study.toml"), toml("**/plan.toml")],
      initializationOptions: options,
      synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/*.{tcl,toml,py}") },
    },
  );
  try {
    await client.start();
  } catch (error) {
    vscode.window.showErrorMessage(
      `hysteron does not start: ${error.message}. The setting hysteron.path says where the program is.`,
    );
  }
}

/** The amplitudes of a test of a bearing; undefined if the user gives none. */
function askAmplitudes(tag) {
  return vscode.window.showInputBox({
    title: `Test of bearing ${tag}`,
    prompt: "Amplitudes of the displacement in the unit of length of the script, for instance 0.1,0.2",
    validateInput: (text) =>
      text.split(",").every((part) => Number(part) > 0) ? undefined : "Positive numbers, separated by commas",
  });
}

/** Run hysteron on a file as a task, in the folder of the file: its terminal stays. */
async function run(context, word, file, tag) {
  const target = file || vscode.window.activeTextEditor?.document.uri.fsPath;
  const chosen = word || (await vscode.window.showQuickPick(["run", "view", "check"]));
  if (!target || !chosen) return;
  const words = [chosen, path.basename(target)];
  if (chosen === "bearing") {
    const amplitudes = await askAmplitudes(tag);
    if (!amplitudes) return;
    words.push("--element", String(tag), "--amplitudes", amplitudes.replaceAll(" ", ""));
  }
  await vscode.workspace.saveAll(false);
  const folder = path.dirname(target);
  const execution = new vscode.ProcessExecution(program(context), words, { cwd: folder });
  const task = new vscode.Task({ type: "hysteron" }, vscode.TaskScope.Workspace, words.join(" "), "hysteron", execution);
  const running = await vscode.tasks.executeTask(task);
  if (chosen !== "bearing") return;
  const picture = path.join(folder, `${path.parse(target).name}_${tag}_test`, "loops.svg");
  const ended = vscode.tasks.onDidEndTaskProcess((event) => {
    if (event.execution !== running) return;
    ended.dispose();
    if (event.exitCode === 0) vscode.commands.executeCommand("vscode.open", vscode.Uri.file(picture), vscode.ViewColumn.Beside);
  });
}

exports.activate = async (context) => {
  context.subscriptions.push(
    vscode.commands.registerCommand("hysteron.command", (word, file, tag) => run(context, word, file, tag)),
    vscode.commands.registerCommand("hysteron.restart", async () => {
      if (client) await client.stop();
      await start(context);
    }),
  );
  await start(context);
};

exports.deactivate = () => (client ? client.stop() : undefined);
