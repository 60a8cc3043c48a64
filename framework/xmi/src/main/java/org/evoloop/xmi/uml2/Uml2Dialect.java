package org.evoloop.xmi.uml2;

import java.util.List;
import java.util.Locale;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.UmlMachine;
import org.evoloop.xmi.dialect.XmiDialect;
import org.evoloop.xmi.dialect.XmiHead;
import org.evoloop.xmi.dialect.XmiStream;
import org.evoloop.xmi.dialect.XmlNode;

/** UML 2 in XMI 2.x. Machines may be anywhere in the model. */
public final class Uml2Dialect implements XmiDialect {

    @Override
    public boolean recognises(XmiHead head) {
        String namespace = head.root().getNamespaceURI();
        return isUml(namespace)
                || (head.root().getLocalPart().equals("XMI")
                        && (XmlNode.isXmi(namespace) || head.version().startsWith("2.")));
    }

    /** Whether this is the namespace of a version of UML 2. */
    static boolean isUml(String uri) {
        return !XmlNode.isXmi(uri) && uri.toLowerCase(Locale.ROOT).contains("uml");
    }

    @Override
    public String toString() {
        return "UML 2 in XMI 2.x (Eclipse UML2, Papyrus, Enterprise Architect, MagicDraw, StarUML)";
    }

    @Override
    public List<DrawnMachine> read(XmiHead head, XmiStream stream) {
        Uml2Document document = Uml2Document.read(head, stream, false);
        return document.machines().stream()
                .<DrawnMachine>map(machine -> new UmlMachine(
                        machine,
                        (title, problems) ->
                                new Uml2ChartReader(new Uml2References(problems), problems).read(machine, title)))
                .toList();
    }
}
