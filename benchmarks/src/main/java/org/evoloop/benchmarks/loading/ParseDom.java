package org.evoloop.benchmarks.loading;

import java.io.File;
import javax.xml.parsers.DocumentBuilderFactory;
import org.evoloop.benchmarks.report.ResidentMemory;

/** Parses a file with the JDK's DOM parser and discards it: the minimum for any other reader. */
public final class ParseDom {
    private ParseDom() {}

    /**
     * Prints the process's peak resident memory in MB.
     *
     * @param arguments the file
     */
    public static void main(String[] arguments) throws Exception {
        int elements = DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new File(arguments[0]))
                .getElementsByTagName("*")
                .getLength();
        if (elements == 0) {
            throw new IllegalStateException("nothing was parsed");
        }
        System.out.println("rss " + ResidentMemory.ofThisProcess());
    }
}
