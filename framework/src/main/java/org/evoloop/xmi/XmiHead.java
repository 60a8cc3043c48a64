package org.evoloop.xmi;

import javax.xml.namespace.QName;

/**
 * What the beginning of a document says about who wrote it.
 *
 * @param root the root element
 * @param version the root's version of XMI, empty if it names none
 * @param exporter the writing tool as it calls itself, empty if it does not
 */
record XmiHead(QName root, String version, String exporter) {

    /** Reads the root's start tag and the header; leaves the stream at the header's end or the first other element. */
    static XmiHead read(XmiStream stream) {
        stream.nextElementWithin(0);
        QName root = stream.getName();
        // XMI 1.x writes xmi.version, XMI 2.x xmi:version.
        String version =
                root.getNamespaceURI().isEmpty() ? stream.attribute("xmi.version") : stream.attribute("version");
        String exporter = "";
        if (stream.nextElementWithin(1)) {
            exporter = stream.attribute("exporter");
            if (stream.at("", "XMI.header")) {
                while (stream.nextElementWithin(2)) {
                    if (stream.at("", "XMI.exporter")) {
                        exporter = stream.getElementText().strip();
                    }
                }
            }
        }
        return new XmiHead(root, version, exporter);
    }

    /** For messages. */
    @Override
    public String toString() {
        return "root element " + Problems.quote(root.toString())
                + (version.isEmpty() ? "" : " of version " + Problems.quote(version))
                + (exporter.isEmpty() ? "" : " written by " + Problems.quote(exporter));
    }
}
