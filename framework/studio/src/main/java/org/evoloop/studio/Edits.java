package org.evoloop.studio;

import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelEditor;
import org.evoloop.xmi.ModelEditor.Edited;

/** Carries out the edits that the page asks for, as edits of the text. */
final class Edits {
    private static final String START = "stateDiagram-v2\n    [*] --> Off\n";

    private Edits() {}

    /** The edited text and the line that shows the edit. */
    static JsonObject edit(JsonRecord request) {
        JsonRecord edit =
                request.inner("edit").orElseThrow(() -> new RequestException("'edit' is missing, with its kind"));
        try {
            Edited edited = edit.text("kind").equals("new-file")
                    ? new Edited(fresh(edit.text("dialect", "mermaid")), 1)
                    : edited(request, edit);
            return new JsonObject().put("text", edited.text()).put("line", edited.line());
        } catch (ModelException refused) {
            throw new RequestException(
                    RequestException.REFUSED,
                    new JsonObject().put("refused", refused.getMessage()),
                    String.valueOf(refused.getMessage()));
        }
    }

    private static Edited edited(JsonRecord request, JsonRecord edit) {
        String path = request.text("path");
        String machine = request.text("machine", "");
        ModelEditor editor = new ModelEditor(path, request.text("text"), machine);
        return switch (edit.text("kind")) {
            case "add-state" -> editor.addState(edit.text("name"), edit.text("parent", ""));
            case "add-transition" ->
                editor.addTransition(
                        edit.text("source"), edit.text("target"), edit.text("event", ""), edit.text("guard", ""));
            case "rename-state" -> renamed(request, edit, editor);
            case "rename-device-state" -> editor.renameDeviceState(edit.text("from"), edit.text("to"));
            case "set-trigger" -> editor.setTrigger(line(edit), edit.text("event"));
            case "set-guard" -> editor.setGuard(line(edit), edit.text("guard"));
            case "set-device-state" -> editor.setDeviceState(edit.text("state"), edit.text("device"));
            case "set-initial" -> editor.setInitial(edit.text("state"));
            case "retarget" -> editor.retarget(line(edit), edit.text("source", ""), edit.text("target", ""));
            case "delete-transition" -> editor.deleteTransition(line(edit));
            case "delete-state" -> editor.deleteState(edit.text("state"));
            default -> throw new RequestException("there is no edit '" + edit.text("kind") + "'");
        };
    }

    private static int line(JsonRecord edit) {
        return (int) Math.max(0, Math.min(Integer.MAX_VALUE, edit.number("line")));
    }

    /** Renames a state in both models of a text, and where a new state wants the device there. */
    private static Edited renamed(JsonRecord request, JsonRecord edit, ModelEditor editor) {
        String from = edit.text("from");
        String to = edit.text("to");
        Edited edited = editor.renameState(from, to);
        if (!request.has("other")) {
            return edited;
        }
        String path = request.text("path");
        String other = request.text("other");
        String text = edited.text();
        boolean known = new ModelEditor(path, text, other).hasState(from);
        text = known ? new ModelEditor(path, text, other).renameState(from, to).text() : text;
        for (String machine : new String[] {other, request.text("machine", "")}) {
            text = new ModelEditor(path, text, machine)
                    .renameDeviceState(from, to)
                    .text();
        }
        return new Edited(text, edited.line());
    }

    private static String fresh(String dialect) {
        return switch (dialect) {
            case "mermaid" -> START;
            case "markdown" ->
                "```mermaid\n---\ntitle: original\n---\n" + START + "```\n\n```mermaid\n---\ntitle: new\n---\n" + START
                        + "```\n";
            case "plantuml" -> "@startuml\n[*] --> Off\n@enduml\n";
            case "scxml" -> """
                    <scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" initial="Off">
                      <state id="Off"/>
                    </scxml>
                    """;
            default -> throw new RequestException("'" + dialect + "' is none of mermaid, markdown, plantuml and scxml");
        };
    }
}
