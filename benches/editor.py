#!/usr/bin/env python3
"""Latency of the language server: from an edit to the diagnostics, and of hover and completion.

    benches/editor.py [--hysteron PROGRAM] [--lines 2000] [--edits 40]

The script is an isolated building whose lines are all written out, as a program that exports models writes them. Each edit
changes one number somewhere in it. Times are in milliseconds: median and largest.
"""

import argparse
import json
import statistics
import subprocess
import time


def building(lines):
    """An isolated building of about so many lines."""
    out = ["model basic -ndm 3 -ndf 6", "geomTransf Linear 1 1 0 0", "geomTransf Linear 2 0 0 1"]
    out += ["uniaxialMaterial Elastic 1 1e6", "uniaxialMaterial Elastic 2 1e3"]
    bays, level, element, nodes = 4, 0, 0, set()
    while len(out) < lines - 30:
        for i in range(bays):
            for j in range(bays):
                tag = 100 * level + 10 * i + j + 1
                nodes.add(tag)
                height = 0.0 if level == 0 else 0.3 + 3.5 * (level - 1)
                out.append(f"node {tag} {6.0 * i} {6.0 * j} {height}")
                if level == 0:
                    out.append(f"fix {tag} 1 1 1 1 1 1")
                    continue
                out.append(f"mass {tag} 15.0 15.0 15.0 0.0 0.0 0.0")
                element += 1
                if level == 1:
                    out.append(f"element elastomericBearingBoucWen {element} {tag - 100} {tag} 2e3 50 0.1 0 2 1 0.5 0.5 "
                               "-P 1 -T 2 -My 2 -Mz 2")
                else:
                    out.append(f"element elasticBeamColumn {element} {tag - 100} {tag} 0.16 30e6 12e6 4e-3 2e-3 2e-3 1")
                for other in ([tag - 10] if i else []) + ([tag - 1] if j else []):
                    element += 1
                    out.append(f"element elasticBeamColumn {element} {other} {tag} 0.12 30e6 12e6 4e-3 2e-3 2e-3 2")
        level += 1
    out += ["timeSeries Linear 1", "pattern Plain 1 1 {"]
    out += [f"    load {tag} 0 0 -150 0 0 0" for tag in sorted(nodes) if tag > 100][:16] + ["}"]
    out += ["constraints Transformation", "numberer RCM", "system BandGeneral", "test NormDispIncr 1e-8 20",
            "algorithm Newton", "integrator LoadControl 0.1", "analysis Static", "analyze 10"]
    return "\n".join(out) + "\n"


class Server:
    def __init__(self, program):
        self.process = subprocess.Popen([program, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.number = 0
        self.ask("initialize", {"capabilities": {}})
        self.tell("initialized", {})

    def send(self, message):
        text = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(text) + text)
        self.process.stdin.flush()

    def receive(self):
        length = 0
        while line := self.process.stdout.readline().strip():
            if line.startswith(b"Content-Length: "):
                length = int(line.split()[1])
        return json.loads(self.process.stdout.read(length))

    def tell(self, method, params):
        self.send({"method": method, "params": params})

    def ask(self, method, params):
        self.number += 1
        self.send({"id": self.number, "method": method, "params": params})
        while (answer := self.receive()).get("id") != self.number:
            pass
        return answer.get("result")

    def diagnostics(self, version):
        while True:
            message = self.receive()
            if message.get("params", {}).get("version") == version:
                return message["params"]["diagnostics"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hysteron", default="target/release/hysteron")
    parser.add_argument("--lines", type=int, default=2000)
    parser.add_argument("--edits", type=int, default=40)
    args = parser.parse_args()
    text = building(args.lines)
    lines = text.split("\n")
    server, uri = Server(args.hysteron), "file:///tmp/editor-bench.tcl"
    document = {"uri": uri, "languageId": "tcl", "version": 1, "text": text}
    begun = time.perf_counter()
    server.tell("textDocument/didOpen", {"textDocument": document})
    found = server.diagnostics(1)
    print(f"{len(lines)} lines, {len(found)} findings; first check {1e3 * (time.perf_counter() - begun):.0f} ms")
    times = {"edit to diagnostics": [], "hover": [], "completion": []}
    elements = [n for n, line in enumerate(lines) if line.startswith("element")]
    for i in range(args.edits):
        n, version = elements[i * len(elements) // args.edits], i + 2
        at = lines[n].rfind(" ") + 1
        place = {"start": {"line": n, "character": at}, "end": {"line": n, "character": at}}
        # A digit before the last word names what is not there; the next edit takes it away.
        change = {"range": place, "text": "9"} if i % 2 == 0 else {"range": last, "text": ""}
        last = {"start": place["start"], "end": {"line": n, "character": at + 1}}
        begun = time.perf_counter()
        server.tell("textDocument/didChange",
                    {"textDocument": {"uri": uri, "version": version}, "contentChanges": [change]})
        found = server.diagnostics(version)
        times["edit to diagnostics"].append(1e3 * (time.perf_counter() - begun))
        assert bool(found) == (i % 2 == 0), (i, found)
        position = {"textDocument": {"uri": uri}, "position": {"line": n, "character": 10}}
        for name in ("hover", "completion"):
            begun = time.perf_counter()
            server.ask(f"textDocument/{name}", position)
            times[name].append(1e3 * (time.perf_counter() - begun))
    for name, all_times in times.items():
        print(f"{name:20} median {statistics.median(all_times):6.1f} ms, largest {max(all_times):6.1f} ms")
    server.ask("shutdown", None)
    server.tell("exit", None)


if __name__ == "__main__":
    main()
