package org.evoloop.xmi.astah;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.XmiFile;

/** A ring of states, each with ten transitions. */
final class LargeMachine {
    private LargeMachine() {}

    static StateMachine read(int transitions) {
        int states = transitions / 10;
        AstahDocument.Machine machine = new AstahDocument.Machine("m", "M").initial("i", "2s7-0");
        for (int state = 0; state < states; state++) {
            machine.state("2s7-" + state, "State " + state);
            for (int event = 0; event < 10; event++) {
                machine.transition(
                        "30n-39fccbec820dc2a17c2273fc5c29fe1a-" + state + "-" + event,
                        "2s7-" + state,
                        "Event " + event,
                        "2s7-" + (state + event) % states);
            }
        }
        byte[] document = new AstahDocument().add(machine).text().getBytes(StandardCharsets.UTF_8);
        return XmiFile.read("F.xml", new ByteArrayInputStream(document)).only();
    }
}
