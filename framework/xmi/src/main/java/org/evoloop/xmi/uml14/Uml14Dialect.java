package org.evoloop.xmi.uml14;

import java.util.List;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.UmlMachine;
import org.evoloop.xmi.dialect.XmiDialect;
import org.evoloop.xmi.dialect.XmiHead;
import org.evoloop.xmi.dialect.XmiStream;

/** UML 1.x in XMI 1.x. Machines may be anywhere in the model; activity graphs are not machines. */
public final class Uml14Dialect implements XmiDialect {

    @Override
    public boolean recognises(XmiHead head) {
        return head.root().getLocalPart().equals("XMI") && head.version().startsWith("1.");
    }

    @Override
    public String toString() {
        return "UML 1.x in XMI 1.x (ArgoUML, Poseidon, Enterprise Architect, StarUML 1)";
    }

    @Override
    public List<DrawnMachine> read(XmiHead head, XmiStream stream) {
        return Uml14Document.read(stream).machines().stream()
                .<DrawnMachine>map(machine -> new UmlMachine(
                        machine, (title, problems) -> new Uml14ChartReader(problems).read(machine, title)))
                .toList();
    }
}
