package org.evoloop.xmi.astah;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The parts of a transition's label: {@code trigger [guard] / effect}, each optional. Astah builds the label from the
 * transition's elements; other writers may give only the label.
 *
 * @param trigger empty if there is none
 * @param guard without brackets; empty if there is none
 * @param effect empty if there is none
 */
record AstahLabel(String trigger, String guard, String effect) {
    /** A guard comes before the end or the slash, so that an index in a trigger such as {@code a[1].x} is not one. */
    private static final Pattern FORM =
            Pattern.compile("(?<trigger>[^\\[/]*?)\\s*(?:\\[(?<guard>.*?)\\])?\\s*(?:/\\s*(?<effect>.*))?");

    /** Parses a label. A text of another form is only a trigger. */
    static AstahLabel parse(String text) {
        Matcher form = FORM.matcher(text);
        if (!form.matches()) {
            return new AstahLabel(text, "", "");
        }
        return new AstahLabel(part(form, "trigger"), part(form, "guard"), part(form, "effect"));
    }

    private static String part(Matcher form, String name) {
        String part = form.group(name);
        return part == null ? "" : part.strip();
    }
}
