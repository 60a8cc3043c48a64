package org.evoloop.xmi.astah;

import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Writes documents in Astah's dialect, one element per line; ids are short, since their form has no meaning.
 *
 * <p>Anything that is not flat is added as text: {@link #vertex} and {@link #transition(String)}.
 */
public final class AstahDocument {
    public static final String UML = "xmlns:UML=\"org.omg.xmi.namespace.UML\"";
    public static final String HEAD = """
            <?xml version = "1.0" encoding = "UTF-8" standalone = "yes"?>
            <XMI xmi.version="1.1" xmlns:JUDE="http://objectclub.esm.co.jp/Jude/namespace/" %s>
            <XMI.header><XMI.documentation>
            <XMI.exporter>Jomt XMI writer</XMI.exporter>
            </XMI.documentation></XMI.header>
            <XMI.content>
            <UML:Model xmi.id="model" name="m">
            <UML:Namespace.ownedElement>
            """.formatted(UML);
    /** The line of the first machine's start tag. */
    public static final int FIRST_LINE = 9;

    private static final String STATE_ATTRIBUTES =
            " version=\"0\" unSolvedFlag=\"false\" isConcurrent=\"true\" isOrthogonal=\"false\" isRegion=\"true\"";

    private final StringBuilder machines = new StringBuilder();
    private final StringBuilder diagrams = new StringBuilder();

    /** The whole document. */
    public String text() {
        return HEAD + machines + "</UML:Namespace.ownedElement>\n</UML:Model>\n<XMI.extension></XMI.extension>\n"
                + "<XMI.extension>\n" + diagrams + "</XMI.extension>\n</XMI.content>\n</XMI>\n";
    }

    public AstahDocument add(Machine machine) {
        machines.append(machine.text());
        return this;
    }

    public AstahDocument diagram(String rawName, String machineId) {
        diagrams.append("<JUDE:StateChartDiagram xmi.id=\"d-").append(machineId).append("\" name=\"");
        diagrams.append(escape(rawName))
                .append("\"><JUDE:StateChartDiagram.semanticModel><UML:StateMachine xmi.idref=\"");
        diagrams.append(machineId).append("\"/></JUDE:StateChartDiagram.semanticModel></JUDE:StateChartDiagram>\n");
        return this;
    }

    public static String encode(String name) {
        return URLEncoder.encode(name, StandardCharsets.UTF_8);
    }

    public static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace("\"", "&quot;")
                .replace("\n", "&#10;");
    }

    /** Off --Clean--> On, a correct machine to which a test adds an error. */
    public static Machine offOn(String id) {
        return new Machine(id, "StateMachine0")
                .initial("i", "off")
                .state("off", "Off")
                .state("on", "On")
                .transition("t", "off", "Clean", "on");
    }

    public static final class Machine {
        private final String id;
        private final String name;
        private final List<String> vertices = new ArrayList<>();
        private final List<String> transitions = new ArrayList<>();

        public Machine(String id, String name) {
            this.id = id;
            this.name = name;
        }

        public Machine initial(String vertexId, String target) {
            vertex("<UML:Pseudostate xmi.id=\"" + vertexId
                    + "\" name=\"InitialPseudostate0\" kind=\"initial\"></UML:Pseudostate>");
            return transition("<UML:Transition xmi.id=\"" + vertexId + "-t\" name=\"\">" + ends(vertexId, target)
                    + "</UML:Transition>");
        }

        public Machine state(String vertexId, String stateName) {
            return vertex("<UML:CompositeState xmi.id=\"" + vertexId + "\" name=\"" + encode(stateName) + "\""
                    + STATE_ATTRIBUTES + "><UML:StateVertex.container><UML:CompositeState xmi.idref=\"top-" + id
                    + "\"/></UML:StateVertex.container></UML:CompositeState>");
        }

        public Machine transition(String transitionId, String source, String event, String target) {
            return transition("<UML:Transition xmi.id=\"" + transitionId + "\" name=\"" + encode(event)
                    + "\" version=\"0\" unSolvedFlag=\"false\">" + trigger(transitionId + "-e", event)
                    + ends(source, target) + "<UML:Transition.stateMachine><UML:StateMachine xmi.idref=\"" + id
                    + "\"/></UML:Transition.stateMachine></UML:Transition>");
        }

        public Machine vertex(String xml) {
            vertices.add(xml);
            return this;
        }

        public Machine transition(String xml) {
            transitions.add(xml);
            return this;
        }

        /** The line of the last vertex in a document that contains only this machine. */
        public int lineOfLastVertex() {
            return FIRST_LINE + 2 + vertices.size();
        }

        /** The line of the last transition in a document that contains only this machine. */
        public int lineOfLastTransition() {
            return FIRST_LINE + 5 + vertices.size() + transitions.size();
        }

        /** The vertices only, one per line. */
        String vertices() {
            return lines(vertices);
        }

        /** The transitions only, one per line. */
        String transitions() {
            return lines(transitions);
        }

        public String text() {
            return "<UML:StateMachine xmi.id=\"" + id + "\" name=\"" + encode(name) + "\" version=\"0\">\n"
                    + "<UML:StateMachine.top><UML:CompositeState xmi.id=\"top-" + id + "\" name=\"\"" + STATE_ATTRIBUTES
                    + ">\n<UML:CompositeState.subvertex>\n" + lines(vertices)
                    + "</UML:CompositeState.subvertex></UML:CompositeState></UML:StateMachine.top>\n"
                    + "<UML:StateMachine.context><UML:ModelElement xmi.idref=\"model\"/></UML:StateMachine.context>\n"
                    + "<UML:StateMachine.transitions>\n" + lines(transitions) + "</UML:StateMachine.transitions>\n"
                    + "</UML:StateMachine>\n";
        }

        private static String lines(List<String> elements) {
            return elements.isEmpty() ? "" : String.join("\n", elements) + "\n";
        }
    }

    public static String trigger(String eventId, String event) {
        return "<UML:Transition.trigger><UML:Event xmi.id=\"" + eventId + "\" name=\"" + encode(event)
                + "\"></UML:Event></UML:Transition.trigger>";
    }

    public static String ends(String source, String target) {
        return "<UML:Transition.source><UML:StateVertex xmi.idref=\"" + source + "\"/></UML:Transition.source>"
                + "<UML:Transition.target><UML:StateVertex xmi.idref=\"" + target + "\"/></UML:Transition.target>";
    }
}
