package org.evoloop.benchmarks.loading;

import java.io.ByteArrayInputStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelFile;

/** The same machine of 1,000 states and 5,000 transitions, read as Mermaid and as UML 2 in XMI, alternating. */
public final class ReadText {
    private static final int STATES = 1_000;
    private static final int EVENTS = 5;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private ReadText() {}

    /**
     * Prints, after as many warm-up turns, the minimum processor time of the thread in ms, of both.
     *
     * @param arguments the number of turns
     */
    public static void main(String[] arguments) {
        int turns = Integer.parseInt(arguments[0]);
        byte[] text = mermaid().getBytes(StandardCharsets.UTF_8);
        byte[] xmi = xmi().getBytes(StandardCharsets.UTF_8);
        double ofText = Double.POSITIVE_INFINITY;
        double ofXmi = Double.POSITIVE_INFINITY;
        for (int turn = -turns; turn < turns; turn++) {
            double read = millis(text);
            double parsed = millis(xmi);
            if (turn >= 0) {
                ofText = Math.min(ofText, read);
                ofXmi = Math.min(ofXmi, parsed);
            }
        }
        System.out.println("text " + ofText);
        System.out.println("xmi " + ofXmi);
    }

    private static double millis(byte[] file) {
        long begun = THREADS.getCurrentThreadCpuTime();
        StateMachine machine =
                ModelFile.read("large", new ByteArrayInputStream(file)).only();
        double millis = (THREADS.getCurrentThreadCpuTime() - begun) / 1e6;
        if (machine.states().size() != STATES || machine.transitions().size() != STATES * EVENTS) {
            throw new IllegalStateException("read " + machine.states().size() + " states");
        }
        return millis;
    }

    /** @param found the printed figures */
    static Row row(Figures found) {
        return new Row(
                "1,000 states and 5,000 transitions as text, processor time",
                "ms",
                found.get("text"),
                Row.Goal.atMostTimes(1, "as XMI", found.get("xmi")),
                Map.of());
    }

    private static int target(int state, int event) {
        return (state * (event + 1) + 1) % STATES;
    }

    private static String mermaid() {
        StringBuilder text = new StringBuilder("stateDiagram-v2\n    [*] --> s0\n");
        for (int state = 0; state < STATES; state++) {
            for (int event = 0; event < EVENTS; event++) {
                text.append("    s").append(state).append(" --> s").append(target(state, event));
                text.append(" : e").append(event).append('\n');
            }
        }
        return text.toString();
    }

    private static String xmi() {
        StringBuilder text = new StringBuilder("<uml:Model xmi:version=\"20131001\""
                + " xmlns:xmi=\"http://www.omg.org/spec/XMI/20131001\""
                + " xmlns:uml=\"http://www.eclipse.org/uml2/5.0.0/UML\" xmi:id=\"model\" name=\"large\">\n"
                + "<packagedElement xmi:type=\"uml:StateMachine\" xmi:id=\"m\" name=\"large\"><region xmi:id=\"r\">\n"
                + "<subvertex xmi:type=\"uml:Pseudostate\" xmi:id=\"i\"/>\n"
                + "<transition xmi:id=\"start\" source=\"i\" target=\"s0\"/>\n");
        for (int state = 0; state < STATES; state++) {
            text.append("<subvertex xmi:type=\"uml:State\" xmi:id=\"s").append(state);
            text.append("\" name=\"s").append(state).append("\"/>\n");
        }
        for (int state = 0; state < STATES; state++) {
            for (int event = 0; event < EVENTS; event++) {
                String id = "t" + state + "-" + event;
                text.append("<transition xmi:id=\"")
                        .append(id)
                        .append("\" source=\"s")
                        .append(state);
                text.append("\" target=\"s").append(target(state, event)).append("\"><trigger xmi:id=\"");
                text.append(id).append("e\" name=\"e").append(event).append("\"/></transition>\n");
            }
        }
        return text.append("</region></packagedElement></uml:Model>\n").toString();
    }
}
