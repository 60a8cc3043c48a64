package org.evoloop.xmi.dialect;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * A format in which people keep state machines, or pictures of them, and that is not read.
 *
 * @param what it is, such as {@code an XState machine}
 * @param remedy how to go on
 * @param extensions of its files, without the dot
 * @param content matches the beginning of such a file, after comments, or its root element
 */
record ForeignFormat(String what, String remedy, List<String> extensions, Pattern content) {
    /** The bytes of a file in which its format shows. */
    static final int HEAD_BYTES = 16 << 10;

    private static final String WRITE = "write the machine in Mermaid or SCXML, or draw it in a UML tool";
    private static final String XMI = "; or " + WRITE;
    private static final String HTML = "<!doctype html";
    private static final String UTF_8_MARK = "\u00ef\u00bb\u00bf";
    /** Lines that begin like a comment of some language. Possessive, since a file may hold thousands. */
    private static final Pattern COMMENTS = Pattern.compile("\\A(?:(?:%%|#(?!\\{)|//)[^\\n]*\\s*+)++");

    /** No text begins like this. */
    private static final String NOTHING = "(?!)";

    /** Of several that match, the first counts. */
    private static final List<ForeignFormat> ALL = List.of(
            format(
                    "a StarUML project",
                    "export XMI in StarUML, with its extension XMI" + XMI,
                    "\\{.*\"_type\"\\s*:\\s*\"(?:Project|UML)",
                    "mdj"),
            format(
                    "an XState machine",
                    "write it in SCXML, where on: { go: 'B' } in A is <state id=\"A\"><transition event=\"go\""
                            + " target=\"B\"/></state>, and after: { 2000: 'B' } is event=\"after 2000 ms\"",
                    "\\{(?=.*\"states\"\\s*:)(?=.*\"(?:initial|on|type|context)\"\\s*:).*|.*\\bcreateMachine\\s*\\("
                            + "|.*\\bfrom ['\"]xstate"),
            format("a JSON file", WRITE, "[\\[{]\\s*[\"\\]}{\\[].*", "json", "json5", "jsonc"),
            format(
                    "a Graphviz graph (DOT)",
                    "write it in SCXML: A -> B [label=\"go\"] is <state id=\"A\"><transition event=\"go\" target=\"B\"/></state>",
                    "(?:/\\*.*?\\*/\\s*)?(?:strict\\s+)?(?:di)?graph\\b[^{;]*\\{",
                    "dot",
                    "gv"),
            format("an Umple model", WRITE, NOTHING, "ump"),
            format("a machine for the State Machine Compiler", WRITE, "%(?:start|class|map)\\b", "sm"),
            format("a SysML 2 model", WRITE, ".*\\bstate def\\b", "sysml", "kerml"),
            format(
                    "a file for state-machine-cat",
                    "convert it: smcat --output-type scxml FILE",
                    ".*[\\w\"]\\s*=>\\s*[\\w\"][^;{}()]*;",
                    "smcat"),
            format("a YAML file", WRITE, "(?:---\\s|%YAML|[\\w.\"'-]+:(?:\\s|$))", "yaml", "yml"),
            format(
                    "a draw.io drawing, with shapes in place of states",
                    WRITE,
                    "<mx(?:file|GraphModel)\\b",
                    "drawio",
                    "dio"),
            format("a yEd graph", WRITE, "<graphml\\b", "graphml"),
            format("an UMLet drawing", WRITE, "<(?:diagram|umlet_diagram)\\b", "uxf"),
            format("an itemis CREATE or Yakindu statechart", WRITE, "<.*\\byakindu\\b", "sct", "ysc"),
            format("a picture", WRITE, "<svg\\b|.PNG|GIF8|%PDF|.{6}JFIF", "svg", "png", "jpg", "gif", "pdf"),
            format("a web page", WRITE, "(?i)<!doctype html|<html\\b", "html", "htm"),
            format(
                    "an Enterprise Architect project",
                    "export XMI 2.1 in Enterprise Architect" + XMI,
                    NOTHING,
                    "eap",
                    "eapx",
                    "qea",
                    "qeax",
                    "feap"),
            format("a Visual Paradigm project", WRITE, NOTHING, "vpp"),
            format("a MagicDraw project", "export UML 2 XMI in MagicDraw" + XMI, NOTHING, "mdzip", "mdxml"),
            format("a Simulink or Stateflow model", WRITE, NOTHING, "slx", "sfx", "mdl"),
            format("a Visio drawing", WRITE, NOTHING, "vsdx", "vsd", "vdx"));

    private static ForeignFormat format(String what, String remedy, String content, String... extensions) {
        return new ForeignFormat(what, remedy, List.of(extensions), Pattern.compile(content, Pattern.DOTALL));
    }

    /** The format that shows in the beginning of a file, or else in its name; empty for none. */
    static Optional<ForeignFormat> of(String file, byte[] head) {
        String text = COMMENTS.matcher(text(head).strip()).replaceFirst("");
        boolean xml = text.startsWith("<") && !text.regionMatches(true, 0, HTML, 0, HTML.length());
        return xml ? Optional.empty() : shown(text).or(() -> ofName(file));
    }

    /** The format with this root element. */
    static Optional<ForeignFormat> of(XmiHead head) {
        return shown("<" + head.root().getLocalPart() + " " + head.namespaces());
    }

    private static Optional<ForeignFormat> shown(String text) {
        return ALL.stream()
                .filter(format -> format.content().matcher(text).lookingAt())
                .findFirst();
    }

    private static String text(byte[] head) {
        boolean wide = head.length > 1 && (head[0] & head[1] & 0xFE) == 0xFE && head[0] != head[1];
        String text = new String(head, wide ? StandardCharsets.UTF_16 : StandardCharsets.ISO_8859_1);
        return text.startsWith(UTF_8_MARK) ? text.substring(UTF_8_MARK.length()) : text;
    }

    /** The format of files with this name. */
    static Optional<ForeignFormat> ofName(String file) {
        String extension = file.substring(file.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        return ALL.stream()
                .filter(format -> format.extensions().contains(extension))
                .findFirst();
    }
}
