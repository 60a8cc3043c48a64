package org.evoloop.xmi.scxml;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import org.evoloop.statechart.DeviceUse;
import org.evoloop.statemachine.Names;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;

/**
 * This project's own attributes: SCXML has no keywords, but allows attributes of other namespaces. They are read from
 * any namespace; only in {@code urn:evoloop} is an unknown one refused, since others have their own.
 */
final class ScxmlOwn {
    /** A name that cannot be an id, such as {@code (A, B)}. */
    static final String NAME = "name";

    private static final String SPONTANEOUS = "spontaneous";
    private static final String URGENT = "urgent";
    private static final String DEVICE = "device";
    private static final String SENDS = "sends";

    private static final Map<String, List<String>> KNOWN = Map.of(
            "state", List.of(NAME, DEVICE, SENDS),
            "parallel", List.of(NAME, DEVICE, SENDS),
            "final", List.of(NAME),
            "history", List.of(NAME),
            "transition", List.of(SPONTANEOUS, URGENT));

    private ScxmlOwn() {}

    /** Whether the device raises the transition's events itself. */
    static boolean isSpontaneous(XmlNode transition) {
        return value(transition, SPONTANEOUS).equals("true");
    }

    /** Whether the transition's events are urgent. */
    static boolean isUrgent(XmlNode transition) {
        return value(transition, URGENT).equals("true");
    }

    /** What a state has to do with the device. */
    static DeviceUse use(XmlNode state) {
        String device = value(state, DEVICE);
        String sends = value(state, SENDS);
        return device.isEmpty() && sends.isEmpty() ? DeviceUse.NONE : new DeviceUse(device, words(sends));
    }

    private static List<String> words(String sends) {
        return Arrays.stream(sends.split("[\\s,]+", -1))
                .filter(word -> !word.isEmpty())
                .toList();
    }

    private static String value(XmlNode node, String name) {
        for (int i = 0; i < node.attributeCount(); i++) {
            String attribute = node.attributeName(i);
            int colon = attribute.indexOf(':');
            if (colon > 0 && attribute.substring(colon + 1).equals(name)) {
                return node.attribute(attribute).strip();
            }
        }
        return "";
    }

    /** What to write for an attribute that is not SCXML's. */
    static String remedy(String element, String attribute) {
        return KNOWN.getOrDefault(element, List.of()).contains(attribute)
                ? "write ev:" + attribute + ", and xmlns:ev=\"urn:evoloop\" in scxml"
                : "remove it";
    }

    /** Reports the own attributes of an element that mean nothing there. */
    static void check(XmlNode node, Problems problems) {
        if (node.attributeCount() > 0) {
            boolean end = node.attribute("final").equals("true");
            List<String> known = end ? List.of() : KNOWN.getOrDefault(node.name(), List.of());
            check(node.attributeNames(), known, ScxmlVocabulary.label(node), node.line(), problems);
            for (String name : known) {
                values(node, name, problems);
            }
        }
    }

    /** The same for the root, which has none. */
    static void check(ScxmlDocument document, Problems problems) {
        check(document.attributes().keySet(), List.of(), "scxml", document.line(), problems);
    }

    private static void check(
            Collection<String> attributes, List<String> known, String label, int line, Problems problems) {
        for (String attribute : attributes) {
            String name = attribute.startsWith(XmlNode.EVOLOOP) ? attribute.substring(XmlNode.EVOLOOP.length()) : "";
            if (!name.isEmpty() && !known.contains(name)) {
                problems.add(
                        line,
                        "attribute " + name + " of urn:evoloop at " + label + " is not known there"
                                + (known.isEmpty() ? "; remove it" : Names.hint(name, known)));
            }
        }
    }

    private static void values(XmlNode node, String name, Problems problems) {
        String attribute = XmlNode.EVOLOOP + name;
        if (!node.attributeNames().contains(attribute)) {
            return;
        }
        String value = node.attribute(attribute).strip();
        boolean truth = name.equals(SPONTANEOUS) || name.equals(URGENT);
        if (truth ? !List.of("true", "false").contains(value) : value.isEmpty()) {
            problems.add(
                    node.line(),
                    "attribute " + name + " of urn:evoloop at " + ScxmlVocabulary.label(node) + " is "
                            + Problems.quote(value) + "; write "
                            + (truth
                                    ? "true or false"
                                    : name.equals(DEVICE)
                                            ? "a state of the original model"
                                            : name.equals(SENDS) ? "events" : "a name"));
        }
    }
}
