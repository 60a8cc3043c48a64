package org.evoloop.xmi.scxml;

import java.util.List;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.XmiDialect;
import org.evoloop.xmi.dialect.XmiHead;
import org.evoloop.xmi.dialect.XmiStream;

/** State Chart XML (SCXML): one machine per document. */
public final class ScxmlDialect implements XmiDialect {

    @Override
    public boolean recognises(XmiHead head) {
        return head.root().getLocalPart().equals("scxml");
    }

    @Override
    public String toString() {
        return "SCXML";
    }

    @Override
    public List<DrawnMachine> read(XmiHead head, XmiStream stream) {
        return List.of(new ScxmlMachine(ScxmlDocument.read(head, stream)));
    }
}
