#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# The Open Job Description template in examples/farm. No engine for it is in Debian, so this checks what the published
# schema (2023-09) asks of such a template, as far as it uses it, and then does what an engine does: fills in the
# parameters, runs a task for each value of the range and the step that depends on them, and reads the progress. The
# picture must be that of a single run. Where the engine itself is installed (openjd), it is asked, too. Ends with 77
# where Python has no YAML.
#   openjd.py PROGRAM
import os, re, shutil, stat, subprocess, sys, tempfile
try:
    import yaml
except ImportError:
    print("skipped: Python has no module yaml")
    sys.exit(77)

program = os.path.realpath(sys.argv[1])
examples = os.path.realpath(os.path.join(os.path.dirname(__file__), "../../examples"))
path = os.path.join(examples, "farm/openjd.yaml")
template = yaml.safe_load(open(path))


def keys(thing, needed, allowed=()):
    missing, unknown = set(needed) - set(thing), set(thing) - set(needed) - set(allowed)
    assert not missing and not unknown, (missing, unknown, thing)


identifier = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,63}$")
reference = re.compile(r"{{ *([\w.]+) *}}")

keys(template, ["specificationVersion", "name", "steps"], ["$schema", "description", "parameterDefinitions"])
assert template["specificationVersion"] == "jobtemplate-2023-09"
assert 1 <= len(template["name"]) <= 128
early, late = set(), set()  # what format strings can name when the job is made, and when a task runs
for each in template["parameterDefinitions"]:
    common = ["description", "default", "allowedValues"]
    more = {"PATH": ["objectType", "dataFlow", "minLength", "maxLength"], "INT": ["minValue", "maxValue"],
            "STRING": ["minLength", "maxLength"], "FLOAT": ["minValue", "maxValue"]}[each["type"]]
    keys(each, ["name", "type"], common + more)
    assert identifier.match(each["name"])
    assert each.get("objectType", "FILE") in ("FILE", "DIRECTORY")
    assert each.get("dataFlow", "NONE") in ("NONE", "IN", "OUT", "INOUT")
    assert each["type"] != "INT" or isinstance(each.get("default", 0), int)
    early.add("RawParam." + each["name"])
    late |= {"Param." + each["name"], "RawParam." + each["name"]}
    if each["type"] != "PATH":  # paths are mapped on the machine where a task runs
        early.add("Param." + each["name"])


def names(text, known):
    unknown = set(reference.findall(text)) - known
    assert not unknown and text.count("{{") == len(reference.findall(text)), (unknown, text)


names(template["name"], early)
done = []
for step in template["steps"]:
    keys(step, ["name", "script"], ["description", "dependencies", "parameterSpace", "hostRequirements"])
    assert 1 <= len(step["name"]) <= 64 and step["name"] not in done
    for each in step.get("dependencies", []):
        keys(each, ["dependsOn"])
        assert each["dependsOn"] in done  # of those before; so there is no circle
    done.append(step["name"])
    here = set(late) | {"Session.WorkingDirectory"}
    for each in step.get("parameterSpace", {}).get("taskParameterDefinitions", []):
        keys(each, ["name", "type", "range"])
        assert each["type"] in ("INT", "FLOAT", "STRING", "PATH") and identifier.match(each["name"])
        names(each["range"], early)
        here |= {"Task.Param." + each["name"], "Task.RawParam." + each["name"]}
    script = step["script"]
    keys(script, ["actions"], ["embeddedFiles"])
    keys(script["actions"], ["onRun"])
    for each in script.get("embeddedFiles", []):
        keys(each, ["name", "type", "data"], ["filename", "runnable"])
        assert each["type"] == "TEXT" and identifier.match(each["name"])
        names(each["data"], here)
        here.add("Task.File." + each["name"])
    action = script["actions"]["onRun"]
    keys(action, ["command"], ["args", "timeout", "cancelation"])
    for each in [action["command"], *action.get("args", [])]:
        names(each, here)
    if "cancelation" in action:
        keys(action["cancelation"], ["mode"], ["notifyPeriodInSeconds"])
        assert action["cancelation"]["mode"] in ("TERMINATE", "NOTIFY_THEN_TERMINATE")
        assert 1 <= action["cancelation"].get("notifyPeriodInSeconds", 1) <= 600
if shutil.which("openjd"):
    subprocess.run(["openjd", "check", path], check=True)

with tempfile.TemporaryDirectory() as folder:
    os.symlink(program, os.path.join(folder, "candelabra"))
    environment = dict(os.environ, PATH=folder + os.pathsep + os.environ["PATH"], HOME=folder)
    scene = os.path.join(examples, "lights/ring.pov")
    given = {"Scene": scene, "Picture": os.path.join(folder, "shared.png"), "Width": 60, "Height": 40, "Samples": 6, "Shards": 3}
    values = {"Param." + name: str(value) for name, value in given.items()}
    whole = os.path.join(folder, "whole.png")
    subprocess.run([program, scene, "+W60", "+H40", "--samples", "6", "+O" + whole, "-V"], check=True, env=environment)

    def filled(text, known):
        return reference.sub(lambda match: known[match.group(1)], text)

    for step in template["steps"]:
        tasks = [{}]
        for each in step.get("parameterSpace", {}).get("taskParameterDefinitions", []):
            first, last = filled(each["range"], values).split("-")
            tasks = [{**task, "Task.Param." + each["name"]: str(i)} for task in tasks for i in range(int(first), int(last) + 1)]
        for task in tasks:
            known = {**values, **task}
            for each in step["script"].get("embeddedFiles", []):
                file = os.path.join(folder, each["name"])
                with open(file, "w") as out:
                    out.write(filled(each["data"], known))
                os.chmod(file, stat.S_IRWXU if each.get("runnable") else stat.S_IRUSR)
                known["Task.File." + each["name"]] = file
            action = step["script"]["actions"]["onRun"]
            words = [filled(text, known) for text in [action["command"], *action.get("args", [])]]
            run = subprocess.run(words, env=environment, cwd=folder, stdout=subprocess.PIPE, text=True)
            assert run.returncode == 0, (words, run.returncode)
            if task:
                heard = [float(line.split()[1]) for line in run.stdout.splitlines() if line.startswith("openjd_progress: ")]
                assert heard and heard[-1] == 100 and heard == sorted(heard), run.stdout
    assert open(given["Picture"], "rb").read() == open(whole, "rb").read()
print("the template fits the schema; its tasks make the picture of a single run, byte for byte")
