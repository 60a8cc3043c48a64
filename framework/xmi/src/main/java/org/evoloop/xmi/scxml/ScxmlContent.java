package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * An element of executable content, and where it stands.
 *
 * @param element such as {@code send}
 * @param block the {@code onentry}, {@code onexit} or {@code transition} around it
 * @param state the state whose block that is; null for that of the document
 * @param direct whether nothing decides if it is run
 */
record ScxmlContent(
        XmlNode element, XmlNode block, @Nullable XmlNode state, boolean direct) {
    private static final Set<String> BLOCKS = Set.of("onentry", "onexit", "transition");
    /** What is in these is somebody else's. */
    private static final Set<String> FOREIGN = Set.of("invoke", "content", "donedata", "datamodel");

    /** All elements with these names in a state, or in the whole document for null. */
    static List<ScxmlContent> all(@Nullable XmlNode state, List<XmlNode> children, Set<String> names) {
        List<ScxmlContent> found = new ArrayList<>();
        for (XmlNode child : children) {
            if (BLOCKS.contains(child.name())) {
                in(child, child, state, names, found);
            } else if (child.name().equals("initial")) {
                found.addAll(all(state, child.children(), names));
            } else if (!FOREIGN.contains(child.name())) {
                found.addAll(all(child, child.children(), names));
            }
        }
        return found;
    }

    private static void in(
            XmlNode outer, XmlNode block, @Nullable XmlNode state, Set<String> names, List<ScxmlContent> found) {
        for (XmlNode child : outer.children()) {
            if (names.contains(child.name())) {
                found.add(new ScxmlContent(child, block, state, outer == block));
            }
            if (!FOREIGN.contains(child.name())) {
                in(child, block, state, names, found);
            }
        }
    }

    /** Whether it is always run when its state is entered or left. */
    boolean isAlwaysIn(String name) {
        return direct && block.name().equals(name);
    }

    /** For messages: {@code send in onentry of state 'On'}. */
    String label() {
        String where = state == null ? "the document" : ScxmlVocabulary.label(state);
        return element.name() + " in " + block.name() + " of " + where;
    }
}
