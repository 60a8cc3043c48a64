package org.evoloop.xmi.uml2;

/** Writes UML 2 documents. */
final class Uml2Text {
    static final String HEAD = """
            <?xml version="1.0" encoding="UTF-8"?>
            <uml:Model xmi:version="20131001" xmlns:xmi="http://www.omg.org/spec/XMI/20131001"
              xmlns:uml="http://www.eclipse.org/uml2/5.0.0/UML" xmi:id="model" name="m">
            """;
    /** The line of the first element in the region of {@link #machine}. */
    static final int FIRST_LINE = 6;

    private Uml2Text() {}

    /** A model with the given elements. */
    static String model(String... elements) {
        return HEAD + String.join("\n", elements) + "\n</uml:Model>\n";
    }

    /** A model with one machine with one region, and elements beside it. */
    static String machine(String region, String... beside) {
        return model("<packagedElement xmi:type='uml:StateMachine' xmi:id='m' name='M'>\n<region xmi:id='r'>\n" + region
                + "\n</region>\n</packagedElement>\n" + String.join("\n", beside));
    }

    /** Two states, an initial pseudostate, and a transition with this content between the states. */
    static String transition(String attributes, String content, String... beside) {
        return machine(
                "<subvertex xmi:type='uml:Pseudostate' xmi:id='i'/>\n" + state("a", "A") + "\n" + state("b", "B")
                        + "\n<transition xmi:id='t0' source='i' target='a'/>\n"
                        + "<transition xmi:type='uml:Transition' xmi:id='t' source='a' target='b' " + attributes + ">"
                        + content + "</transition>",
                beside);
    }

    static String state(String id, String name) {
        return "<subvertex xmi:type='uml:State' xmi:id='" + id + "' name='" + name + "'/>";
    }
}
