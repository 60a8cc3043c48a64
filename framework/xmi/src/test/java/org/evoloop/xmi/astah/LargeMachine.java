package org.evoloop.xmi.astah;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Enumeration;
import java.util.Iterator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelFile;

/**
 * A ring of states, each with ten transitions, and its diagram, which is four times as large; generated while it is
 * read, so that only the reader uses memory.
 */
final class LargeMachine {
    private static final String ID = "-39fccbec820dc2a17c2273fc5c29fe1a-";

    private LargeMachine() {}

    static StateMachine read(int transitions) {
        int states = transitions / 10;
        AstahDocument.Machine machine = new AstahDocument.Machine("m", "M");
        String[] parts = new AstahDocument()
                .add(machine.vertex("STATES").transition("TRANSITIONS"))
                .diagram("ring", "m")
                .text()
                .split("STATES\n|TRANSITIONS\n|</JUDE:StateChartDiagram>\n");
        AstahDocument.Machine start = new AstahDocument.Machine("m", "M").initial("i", "2s7-0");
        Stream<String> document = Stream.of(
                        Stream.of(parts[0]),
                        Stream.of(start.vertices()),
                        IntStream.range(0, states).mapToObj(LargeMachine::state),
                        Stream.of(parts[1], start.transitions()),
                        IntStream.range(0, transitions).mapToObj(index -> transition(index, states)),
                        Stream.of(parts[2]),
                        IntStream.range(0, transitions).mapToObj(LargeMachine::presentation),
                        Stream.of("</JUDE:StateChartDiagram>\n", parts[3]))
                .flatMap(part -> part);
        return ModelFile.read("F.xml", new SequenceInputStream(streams(document.iterator())))
                .only();
    }

    private static Enumeration<InputStream> streams(Iterator<String> parts) {
        return new Enumeration<>() {
            @Override
            public boolean hasMoreElements() {
                return parts.hasNext();
            }

            @Override
            public InputStream nextElement() {
                return new ByteArrayInputStream(parts.next().getBytes(StandardCharsets.UTF_8));
            }
        };
    }

    private static String state(int state) {
        return new AstahDocument.Machine("m", "M")
                .state("2s7-" + state, "State " + state)
                .vertices();
    }

    private static String transition(int index, int states) {
        int state = index / 10;
        int event = index % 10;
        return new AstahDocument.Machine("m", "M")
                .transition("30n" + ID + index, "2s7-" + state, "Event " + event, "2s7-" + (state + event) % states)
                .transitions();
    }

    private static String presentation(int index) {
        return "<JUDE:TransitionPresentation xmi.id=\"p" + ID + index
                + "\" version=\"0\" depth=\"2147483624\" width=\"93.0\""
                + " height=\"36.09375\" doAutoResize=\"true\" visibility=\"true\" label=\"Event\">"
                + "<JUDE:UPresentation.semanticModel><UML:Transition xmi.idref=\"30n" + ID + index
                + "\"/></JUDE:UPresentation.semanticModel><JUDE:UPresentation.servers><JUDE:CompositeStatePresentation"
                + " xmi.idref=\"q" + index + "\"/></JUDE:UPresentation.servers><JUDE:PathPresentation.points>"
                + "<XMI.field><XMI.field>281.0</XMI.field><XMI.field>141.0</XMI.field></XMI.field>".repeat(12)
                + "</JUDE:PathPresentation.points></JUDE:TransitionPresentation>\n";
    }
}
