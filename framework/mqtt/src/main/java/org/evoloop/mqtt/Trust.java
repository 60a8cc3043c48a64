package org.evoloop.mqtt;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.util.Collection;
import javax.net.ssl.TrustManagerFactory;

/** Trusts the certificates of a file. */
final class Trust {
    private Trust() {}

    /** @throws IllegalArgumentException if the file cannot be read, or contains no certificate */
    static TrustManagerFactory in(Path file) {
        Collection<? extends Certificate> certificates;
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            certificates = CertificateFactory.getInstance("X.509").generateCertificates(in);
        } catch (IOException unreadable) {
            throw new IllegalArgumentException("the certificates of ca=" + file
                    + " cannot be read; check that the file is there, and that this user may read it");
        } catch (CertificateException malformed) {
            throw noCertificate(file);
        }
        if (certificates.isEmpty()) {
            throw noCertificate(file);
        }
        try {
            KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
            store.load(null, null);
            for (Certificate each : certificates) {
                store.setCertificateEntry("ca" + store.size(), each);
            }
            TrustManagerFactory trust = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
            trust.init(store);
            return trust;
        } catch (GeneralSecurityException | IOException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private static IllegalArgumentException noCertificate(Path file) {
        return new IllegalArgumentException(
                "ca=" + file + " holds no certificate; it must be in PEM, with -----BEGIN CERTIFICATE-----");
    }
}
