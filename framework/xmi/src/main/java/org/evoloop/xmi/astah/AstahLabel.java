package org.evoloop.xmi.astah;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What the text on a transition says: {@code trigger [guard] / effect}, each part optional. Astah builds it from the
 * elements; in files of other hands it may be all there is.
 *
 * @param trigger empty if there is none
 * @param guard without brackets; empty if there is none
 * @param effect empty if there is none
 */
record AstahLabel(String trigger, String guard, String effect) {
    /** A guard stands before the end or the slash, so that an index in a trigger such as {@code a[1].x} is none. */
    private static final Pattern FORM =
            Pattern.compile("(?<trigger>[^\\[/]*?)\\s*(?:\\[(?<guard>.*?)\\])?\\s*(?:/\\s*(?<effect>.*))?");

    /** A text that has not this form is a trigger as a whole. */
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
