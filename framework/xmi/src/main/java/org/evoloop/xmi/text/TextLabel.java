package org.evoloop.xmi.text;

import java.util.List;
import java.util.regex.Pattern;

/**
 * The text of a transition's label in its parts, so that one is replaced and the others stay as they are written.
 *
 * @param trigger with the blanks behind it
 * @param guards with their brackets, and the blanks behind them
 * @param rest the effects and what follows
 */
record TextLabel(Syntax syntax, String trigger, String guards, String rest) {
    private static final Pattern SIGNS = Pattern.compile("[,/\\[\\](){};<\"\\\\]");

    static TextLabel of(String text, Syntax syntax) {
        String flat = Statements.flat(text);
        int local = Label.LOCALS.stream()
                .filter(flat.stripTrailing()::endsWith)
                .findFirst()
                .map(ending -> flat.stripTrailing().length() - ending.length())
                .orElse(flat.length());
        int slash = Label.Marks.slash(flat, syntax);
        int behind = slash < 0 ? local : slash;
        int guards = Label.guardsAt(flat.substring(0, behind), syntax);
        return new TextLabel(syntax, text.substring(0, guards), text.substring(guards, behind), text.substring(behind));
    }

    TextLabel withTrigger(String events) {
        String event = put(trigger, escaped(events.strip()));
        boolean joined = trigger.isEmpty() && !event.isEmpty() && !guards.isEmpty();
        return new TextLabel(syntax, joined ? event + " " : event, guards, rest);
    }

    /** @param text of a guard, without its brackets; empty for none */
    TextLabel withGuard(String text) {
        String guard = text.isBlank() ? "" : "[" + guard(text.strip()) + "]";
        String before =
                trigger.isEmpty() || guard.isEmpty() || !trigger.stripTrailing().equals(trigger)
                        ? trigger
                        : trigger + " ";
        return new TextLabel(syntax, before, put(guards, guard), rest);
    }

    /** The part in place of another, with the blanks that were behind it. */
    private static String put(String old, String part) {
        String blanks = old.substring(old.stripTrailing().length());
        return part.isEmpty() ? "" : part + blanks;
    }

    private String escaped(String events) {
        return reads(events, events) ? events : escape(events);
    }

    /** Whether the text names events and nothing else. */
    private boolean reads(String text, String events) {
        try {
            Label read = Label.parse(text, 1, syntax);
            boolean ends = syntax == Syntax.MERMAID && text.indexOf(';') >= 0;
            return !ends
                    && !text.contains("{")
                    && !text.contains("}")
                    && !text.contains("%%")
                    && read.guards().isEmpty()
                    && read.effects().isEmpty()
                    && read.local() == events.endsWith(Label.LOCAL)
                    && !read.triggers().isEmpty();
        } catch (Refusal refused) {
            return false;
        }
    }

    private String guard(String text) {
        try {
            boolean plain = text.indexOf(';') < 0
                    && !text.contains("{")
                    && Label.parse("[" + text + "]", 1, syntax)
                            .equals(new Label(List.of(), List.of(text), List.of(), false));
            return plain ? text : escape(text);
        } catch (Refusal refused) {
            return escape(text);
        }
    }

    private String escape(String text) {
        return SIGNS.matcher(text)
                .replaceAll(sign -> syntax == Syntax.MERMAID
                        ? "#" + (int) sign.group().charAt(0) + ";"
                        : "<U+" + String.format("%04X", (int) sign.group().charAt(0)) + ">");
    }

    /** The whole label. */
    String text() {
        String behind = guards.isEmpty() && !trigger.isEmpty() ? "" : guards;
        String head = trigger + behind;
        boolean apart = !head.isEmpty()
                && !rest.isEmpty()
                && head.stripTrailing().equals(head)
                && (trigger.isEmpty() || guards.isEmpty())
                && !rest.startsWith(" ");
        return (head + (apart && needsBlank(head) ? " " : "") + rest).stripTrailing();
    }

    /** After a change a slash must not be joined to a word, where it could be a letter. */
    private static boolean needsBlank(String head) {
        return !head.isEmpty() && !Character.isWhitespace(head.charAt(head.length() - 1));
    }
}
