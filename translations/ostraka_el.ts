<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="el" sourcelanguage="en">
  <context>
    <name>ComputeBatch</name>
    <message>
      <source>The disk has only %1 MB left; a batch needs more. Nothing is lost: make room, then go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στον σκληρό δίσκο μένουν μόνο %1 MB· μια παρτίδα χρειάζεται περισσότερα. Τίποτα δεν χάθηκε: κάντε χώρο και συνεχίστε.</translation>
    </message>
    <message>
      <source>%1: this number was typed on the plate, but no sherd with a context lies there; give it in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: αυτός ο αριθμός γράφτηκε πάνω στον δίσκο, αλλά εκεί δεν υπάρχει όστρακο με πλαίσιο· δώστε τον στον κατάλογο.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) were counted on the plate, and another number was found; look at the map for one that is missing or cut in two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Μετρήθηκε %n όστρακο πάνω στον δίσκο και βρέθηκε άλλος αριθμός· αναζητήστε στον χάρτη αυτό που λείπει ή κόπηκε στα δύο.</numerusform>
        <numerusform>Μετρήθηκαν %n όστρακα πάνω στον δίσκο και βρέθηκε άλλος αριθμός· αναζητήστε στον χάρτη αυτό που λείπει ή κόπηκε στα δύο.</numerusform>
      </translation>
    </message>
    <message>
      <source>Pairs were decided while the batch was computed; compute it again for them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποφασίστηκαν ζεύγη ενώ υπολογιζόταν η παρτίδα· υπολογίστε την ξανά γι' αυτά.</translation>
    </message>
  </context>
  <context>
    <name>Fields</name>
    <message>
      <source>number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αριθμός</translation>
    </message>
    <message>
      <source>identifier</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ταυτότητα</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κατάσταση</translation>
    </message>
    <message>
      <source>void because</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>άκυρο επειδή</translation>
    </message>
    <message>
      <source>site</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>θέση</translation>
    </message>
    <message>
      <source>trench</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τομή</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλαίσιο</translation>
    </message>
    <message>
      <source>bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σακούλα</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μέρος</translation>
    </message>
    <message>
      <source>ware</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κεραμική κατηγορία</translation>
    </message>
    <message>
      <source>fabric</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πηλός</translation>
    </message>
    <message>
      <source>inclusions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>προσμίξεις</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κατασκευή</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όπτηση</translation>
    </message>
    <message>
      <source>surface outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εξωτερική επιφάνεια</translation>
    </message>
    <message>
      <source>surface inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εσωτερική επιφάνεια</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διακόσμηση</translation>
    </message>
    <message>
      <source>Munsell outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell έξω</translation>
    </message>
    <message>
      <source>Munsell inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell μέσα</translation>
    </message>
    <message>
      <source>Munsell core</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell πυρήνας</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διατήρηση</translation>
    </message>
    <message>
      <source>joins with</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>συνανήκει με</translation>
    </message>
    <message>
      <source>vessel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αγγείο</translation>
    </message>
    <message>
      <source>period</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>περίοδος</translation>
    </message>
    <message>
      <source>date</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χρονολόγηση</translation>
    </message>
    <message>
      <source>length, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μήκος, mm</translation>
    </message>
    <message>
      <source>width, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλάτος, mm</translation>
    </message>
    <message>
      <source>thickness least, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πάχος ελάχιστο, mm</translation>
    </message>
    <message>
      <source>thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πάχος, mm</translation>
    </message>
    <message>
      <source>thickness most, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πάχος μέγιστο, mm</translation>
    </message>
    <message>
      <source>area, mm²</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εμβαδόν, mm²</translation>
    </message>
    <message>
      <source>volume, mm³</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όγκος, mm³</translation>
    </message>
    <message>
      <source>not seen, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αθέατο, %</translation>
    </message>
    <message>
      <source>rim diameter, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διάμετρος χείλους, mm</translation>
    </message>
    <message>
      <source>rim kept, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σωζόμενο χείλος, %</translation>
    </message>
    <message>
      <source>weight, g</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>βάρος, g</translation>
    </message>
    <message>
      <source>batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>παρτίδα</translation>
    </message>
    <message>
      <source>note</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σημείωση</translation>
    </message>
    <message>
      <source>scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κλίμακα</translation>
    </message>
  </context>
  <context>
    <name>Job</name>
    <message>
      <source>The memory does not suffice; close other programs and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μνήμη δεν φτάνει· κλείστε άλλα προγράμματα και δοκιμάστε ξανά.</translation>
    </message>
    <message>
      <source>This is a defect of the program; please report it with the log (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό είναι σφάλμα του προγράμματος· αναφέρετέ το μαζί με το ημερολόγιο (%1).</translation>
    </message>
  </context>
  <context>
    <name>PlaceText</name>
    <message>
      <source>%1 bag %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 σακούλα %2</translation>
    </message>
    <message>
      <source>A site, a context and a bag are needed so that the sherds can be numbered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρειάζονται θέση, πλαίσιο και σακούλα για να αριθμηθούν τα όστρακα.</translation>
    </message>
    <message>
      <source>site %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>θέση %1</translation>
    </message>
    <message>
      <source>trench %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τομή %1</translation>
    </message>
    <message>
      <source>context %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλαίσιο %1</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σακούλα %1</translation>
    </message>
  </context>
  <context>
    <name>Rig</name>
    <message>
      <source>its file is missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>λείπει το αρχείο της</translation>
    </message>
    <message>
      <source>ready (calibrated today)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>έτοιμη (βαθμονομήθηκε σήμερα)</translation>
    </message>
    <message numerus="yes">
      <source>ready (%n day(s) old)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>έτοιμη (%n ημέρας)</numerusform>
        <numerusform>έτοιμη (%n ημερών)</numerusform>
      </translation>
    </message>
    <message>
      <source>virtual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εικονική</translation>
    </message>
  </context>
  <context>
    <name>Stage</name>
    <message>
      <source>cameras</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κάμερες</translation>
    </message>
    <message>
      <source>sherd or plate, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όστρακο ή δίσκος, μπροστά</translation>
    </message>
    <message>
      <source>sherd or plate, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όστρακο ή δίσκος, πίσω</translation>
    </message>
    <message>
      <source>surface, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>επιφάνεια, μπροστά</translation>
    </message>
    <message>
      <source>surface, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>επιφάνεια, πίσω</translation>
    </message>
    <message>
      <source>one scan a sherd, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μία σάρωση ανά όστρακο, μπροστά</translation>
    </message>
    <message>
      <source>one scan a sherd, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μία σάρωση ανά όστρακο, πίσω</translation>
    </message>
    <message>
      <source>which back belongs to which front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ποια πίσω όψη ανήκει σε ποια μπροστινή</translation>
    </message>
    <message>
      <source>models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μοντέλα</translation>
    </message>
    <message>
      <source>report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αναφορά</translation>
    </message>
    <message>
      <source>catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κατάλογος</translation>
    </message>
    <message>
      <source>begins</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχίζει</translation>
    </message>
    <message>
      <source>more candidates for doubtful pairs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>περισσότεροι υποψήφιοι για αμφίβολα ζεύγη</translation>
    </message>
  </context>
  <context>
    <name>Time</name>
    <message numerus="yes">
      <source>%n s left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>απομένει %n δ</numerusform>
        <numerusform>απομένουν %n δ</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>απομένει %n λεπτό</numerusform>
        <numerusform>απομένουν %n λεπτά</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 h %2 min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>απομένουν %1 ώρες %2 λεπτά</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui</name>
    <message>
      <source>numbered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αριθμημένο</translation>
    </message>
    <message>
      <source>void</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>άκυρο</translation>
    </message>
    <message>
      <source>draft</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πρόχειρο</translation>
    </message>
    <message>
      <source>on a scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>με ζυγαριά</translation>
    </message>
    <message>
      <source>with a calliper</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>με παχύμετρο</translation>
    </message>
    <message>
      <source>estimated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κατ’ εκτίμηση</translation>
    </message>
    <message>
      <source>by the program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>από το πρόγραμμα</translation>
    </message>
    <message>
      <source>aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>στην άκρη</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ξανά</translation>
    </message>
    <message>
      <source>%1 or %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ή %2</translation>
    </message>
    <message>
      <source>The photograph is not there any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η φωτογραφία δεν υπάρχει πια.</translation>
    </message>
    <message>
      <source>The printer or file cannot be written; choose another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν γίνεται εγγραφή στον εκτυπωτή ή στο αρχείο· επιλέξτε άλλο.</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μπροστινή όψη</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω όψη</translation>
    </message>
    <message>
      <source>The printer took no further page.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο εκτυπωτής δεν δέχτηκε άλλη σελίδα.</translation>
    </message>
    <message>
      <source>The printer or file could not be finished; is the disk full?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εκτύπωση ή το αρχείο δεν ολοκληρώθηκε· μήπως γέμισε ο δίσκος;</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3: their rims differ by %4 only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 και το %2 ταιριάζουν και τα δύο στο %3: οι ακμές τους διαφέρουν μόνο κατά %4.</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 και το %2 ταιριάζουν και τα δύο στο %3.</translation>
    </message>
    <message>
      <source>%1 would fit %2 nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 θα ταίριαζε σχεδόν εξίσου καλά στο %2.</translation>
    </message>
    <message>
      <source>Another partner fits nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα άλλο ταίρι ταιριάζει σχεδόν εξίσου καλά.</translation>
    </message>
    <message>
      <source>Its back was given to another front: is %1 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη του δόθηκε σε άλλη μπροστινή: είναι τώρα το %1 το σωστό;</translation>
    </message>
    <message>
      <source>%1 fits hardly better than a stranger's back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 μόλις που ταιριάζει καλύτερα από την πίσω όψη ενός ξένου οστράκου.</translation>
    </message>
    <message>
      <source>The two sides fit nearly as well in another position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι δύο όψεις ταιριάζουν σχεδόν εξίσου καλά σε άλλη θέση.</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>under 1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κάτω από 1 %</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
      <source>The back lies upside down: both sides face the same way.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη είναι ανάποδα: και οι δύο όψεις κοιτούν προς την ίδια πλευρά.</translation>
    </message>
    <message>
      <source>The faces cross: %1 of the front lies behind the back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι όψεις διασταυρώνονται: το %1 της μπροστινής βρίσκεται πίσω από την πίσω όψη.</translation>
    </message>
    <message>
      <source>The two scans share almost no broken edge; outlines alone tie them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι δύο σαρώσεις δεν έχουν σχεδόν καμία κοινή θραύση· μόνο τα περιγράμματα τις συνδέουν.</translation>
    </message>
    <message>
      <source>The broken edges do not fit: %1 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι θραύσεις δεν ταιριάζουν: απόσταση %1.</translation>
    </message>
    <message>
      <source>The rim hardly fixes the position: uncertain by %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η ακμή μόλις που ορίζει τη θέση: αβεβαιότητα %1.</translation>
    </message>
    <message>
      <source>A place %1 along the rim fits nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια θέση %1 πιο πέρα στην ακμή ταιριάζει σχεδόν εξίσου καλά.</translation>
    </message>
    <message>
      <source>The rims cannot be compared; outlines alone tie these sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι ακμές δεν συγκρίνονται· μόνο τα περιγράμματα συνδέουν αυτές τις όψεις.</translation>
    </message>
    <message>
      <source>look</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>δείτε το</translation>
    </message>
    <message>
      <source>no back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χωρίς πίσω όψη</translation>
    </message>
    <message>
      <source>sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>βέβαιο</translation>
    </message>
    <message>
      <source>decided</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αποφασισμένο</translation>
    </message>
    <message>
      <source>set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>στην άκρη</translation>
    </message>
    <message>
      <source>shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>νέα λήψη</translation>
    </message>
    <message>
      <source>%1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 – %2</translation>
    </message>
    <message>
      <source>No back was found for it. Choose one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν βρέθηκε πίσω όψη. Επιλέξτε μία, ή βάλτε το στην άκρη.</translation>
    </message>
    <message>
      <source>The program is sure: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα είναι βέβαιο: %1.</translation>
    </message>
    <message>
      <source>Decided by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποφασίστηκε από %1 στις %2.</translation>
    </message>
    <message>
      <source>Set aside by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπήκε στην άκρη από %1 στις %2.</translation>
    </message>
    <message>
      <source>To be shot again, says %1, %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Θέλει νέα λήψη, λέει ο/η %1, %2.</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σακούλα %1</translation>
    </message>
    <message>
      <source>no front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χωρίς μπροστινή όψη</translation>
    </message>
    <message>
      <source>This back is set aside. Drag it onto a front to use it after all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η πίσω όψη είναι στην άκρη. Σύρετέ τη σε μια μπροστινή για να χρησιμοποιηθεί τελικά.</translation>
    </message>
    <message>
      <source>This back is to be shot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η πίσω όψη θέλει νέα λήψη.</translation>
    </message>
    <message>
      <source>No front holds this back. Drag it onto its front, join it to another, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία μπροστινή όψη δεν έχει αυτή την πίσω. Σύρετέ τη στη μπροστινή της, ενώστε τη με άλλη, ή βάλτε τη στην άκρη.</translation>
    </message>
    <message>
      <source>%1 ?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ?</translation>
    </message>
    <message numerus="yes">
      <source>%1 of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1 από %n όστρακο</numerusform>
        <numerusform>%1 από %n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>%1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2</translation>
    </message>
    <message>
      <source>in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αμφίβολη</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο</numerusform>
        <numerusform>%n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>Its back %1 was given to %2: is %3 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη του %1 δόθηκε στο %2: είναι τώρα το %3 το σωστό;</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2. Choose another one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη του %1 δόθηκε στο %2. Επιλέξτε άλλη, ή βάλτε το στην άκρη.</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2; next best %3, %4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη του %1 δόθηκε στο %2· επόμενη καλύτερη %3, %4.</translation>
    </message>
    <message>
      <source>Decided by %1 on %2, turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποφασίστηκε από %1 στις %2, στράφηκε με το χέρι.</translation>
    </message>
    <message>
      <source>The rims hardly meet: %1 of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι ακμές μόλις συναντιούνται: το %1.</translation>
    </message>
    <message>
      <source>by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>με το χέρι</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχικό σημείο</translation>
    </message>
    <message>
      <source>settled</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ρυθμισμένο</translation>
    </message>
    <message>
      <source>Turned by hand: %1 of the rims meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στράφηκε με το χέρι: συναντιέται το %1 των ακμών.</translation>
    </message>
    <message>
      <source>Turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στράφηκε με το χέρι.</translation>
    </message>
    <message>
      <source>Another start point is tried: %1 of the rims meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμάζεται άλλο αρχικό σημείο: συναντιέται το %1 των ακμών.</translation>
    </message>
    <message>
      <source>Another start point is tried.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμάζεται άλλο αρχικό σημείο.</translation>
    </message>
    <message>
      <source>Settled by the rims: %1 of them meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ρυθμίστηκε από τις ακμές: συναντιέται το %1.</translation>
    </message>
    <message>
      <source>Settled by the rims.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ρυθμίστηκε από τις ακμές.</translation>
    </message>
    <message>
      <source>%1 is tried: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμάζεται το %1: %2.</translation>
    </message>
    <message>
      <source>%1 is tried: %2, rims %3 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμάζεται το %1: %2, ακμές σε απόσταση %3.</translation>
    </message>
    <message>
      <source>%1 is tried: %2; its rims do not meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμάζεται το %1: %2· οι ακμές δεν συναντιούνται.</translation>
    </message>
    <message>
      <source>%1 decided for %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το άτομο %1 αποφάσισε για το %2.</translation>
    </message>
    <message>
      <source>The program says %1, %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα λέει %1, %2.</translation>
    </message>
    <message>
      <source>Joined with %1 by %2; it is one piece once the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ενώθηκε με το %1 από %2· γίνεται ένα κομμάτι όταν υπολογιστεί η παρτίδα.</translation>
    </message>
    <message>
      <source>Cut in two by %1; its pieces come when the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κόπηκε στα δύο από %1· τα κομμάτια έρχονται όταν υπολογιστεί η παρτίδα.</translation>
    </message>
    <message>
      <source>joined</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ενώθηκε</translation>
    </message>
    <message>
      <source>cut</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κόπηκε</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BatchDelegate</name>
    <message>
      <source>%1, %2 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2 %</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BatchImporter</name>
    <message>
      <source>Import of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή του %1</translation>
    </message>
    <message>
      <source>The copy cannot be put in its place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αντίγραφο δεν μπορεί να μπει στη θέση του: %1.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BatchQueue</name>
    <message numerus="yes">
      <source>%n sherd(s), all sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο, βέβαιο</numerusform>
        <numerusform>%n όστρακα, όλα βέβαια</numerusform>
      </translation>
    </message>
    <message>
      <source>a draft: look, then compute it again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>προσχέδιο: δείτε το και υπολογίστε ξανά</translation>
    </message>
    <message>
      <source>the scale is not right: see the report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η κλίμακα δεν είναι σωστή: δείτε την αναφορά</translation>
    </message>
    <message>
      <source>%1; joined to %2 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1· ένωση στα %2 mm</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδα %1</translation>
    </message>
    <message>
      <source>Warning: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Προσοχή: %1</translation>
    </message>
    <message numerus="yes">
      <source>%1 is computed: %n sherd(s).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Η %1 υπολογίστηκε: %n όστρακο.</numerusform>
        <numerusform>Η %1 υπολογίστηκε: %n όστρακα.</numerusform>
      </translation>
    </message>
    <message>
      <source>You stopped it. What was computed so far is kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τη σταματήσατε. Ό,τι υπολογίστηκε ως τώρα κρατιέται.</translation>
    </message>
    <message>
      <source>You took it out of the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τη βγάλατε από την ουρά.</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ξανά</translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) wait.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Σε παύση· περιμένει %n παρτίδα.</numerusform>
        <numerusform>Σε παύση· περιμένουν %n παρτίδες.</numerusform>
      </translation>
    </message>
    <message>
      <source>%1: paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: σε παύση</translation>
    </message>
    <message>
      <source>%1: %2, %3 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2, %3 %</translation>
    </message>
    <message>
      <source>being photographed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>φωτογραφίζεται</translation>
    </message>
    <message>
      <source>waits for its turn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>περιμένει τη σειρά της</translation>
    </message>
    <message>
      <source>is being computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>υπολογίζεται</translation>
    </message>
    <message>
      <source>paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σε παύση</translation>
    </message>
    <message>
      <source>stopped</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σταμάτησε</translation>
    </message>
    <message>
      <source>wants your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>θέλει το μάτι σας</translation>
    </message>
    <message>
      <source>done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>έτοιμη</translation>
    </message>
    <message>
      <source>decided; to be computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αποφασισμένη· μένει ο υπολογισμός</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο</numerusform>
        <numerusform>%n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>sure %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>βέβαια %1</translation>
    </message>
    <message>
      <source>decided %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αποφασισμένα %1</translation>
    </message>
    <message>
      <source>ask %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αμφίβολα %1</translation>
    </message>
    <message numerus="yes">
      <source>%1; but %n counted on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1· αλλά %n μετρήθηκε στον δίσκο</numerusform>
        <numerusform>%1· αλλά %n μετρήθηκαν στον δίσκο</numerusform>
      </translation>
    </message>
    <message>
      <source>draft, to be computed again; %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>προσχέδιο, να υπολογιστεί ξανά· %1</translation>
    </message>
    <message>
      <source>%1 waits for the draft of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 περιμένει το προσχέδιο του %2.</translation>
    </message>
    <message>
      <source>Camera %1 was bumped: it misses the marks by %2 px, %3 mm from where it was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα %1 μετακινήθηκε: χάνει τα σημάδια κατά %2 px, %3 mm από τη θέση βαθμονόμησης.</translation>
    </message>
    <message>
      <source>This batch's cameras were found anew; calibrate the rig again (C).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Για αυτή την παρτίδα οι κάμερες βρέθηκαν εκ νέου· βαθμονομήστε ξανά τη διάταξη (C).</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BigButton</name>
    <message>
      <source>Key: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πλήκτρο: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BulkEdit</name>
    <message>
      <source>Field to change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πεδίο που αλλάζει</translation>
    </message>
    <message>
      <source>New value for all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέα τιμή για όλα</translation>
    </message>
    <message>
      <source>new value; empty deletes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>νέα τιμή· το κενό διαγράφει</translation>
    </message>
    <message>
      <source>sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όστρακο</translation>
    </message>
    <message>
      <source>now</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τώρα</translation>
    </message>
    <message>
      <source>then</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μετά</translation>
    </message>
    <message>
      <source>What would change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι θα άλλαζε</translation>
    </message>
    <message>
      <source>Change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αλλαγή</translation>
    </message>
    <message>
      <source>Give numbers to the drafts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρίθμηση των πρόχειρων</translation>
    </message>
    <message>
      <source>Field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πεδίο</translation>
    </message>
    <message>
      <source>Value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τιμή</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο επιλέχθηκε</numerusform>
        <numerusform>%n όστρακα επιλέχθηκαν</numerusform>
      </translation>
    </message>
    <message>
      <source>Type a value to see what would change.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Γράψτε μια τιμή για να δείτε τι θα άλλαζε.</translation>
    </message>
    <message>
      <source>Preview of a change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Προεπισκόπηση αλλαγής</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χωρίς αριθμό ακόμη</translation>
    </message>
    <message>
      <source>refused: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>απορρίφθηκε: %1</translation>
    </message>
    <message>
      <source>%1 change, %2 stay as they are, %3 are refused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αλλάζουν %1, μένουν ως έχουν %2, απορρίπτονται %3.</translation>
    </message>
    <message numerus="yes">
      <source>Change %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Αλλαγή %n οστράκου</numerusform>
        <numerusform>Αλλαγή %n οστράκων</numerusform>
      </translation>
    </message>
    <message>
      <source>Progress of the changes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος των αλλαγών</translation>
    </message>
    <message>
      <source>Stop and take back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή και ανάκληση</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CandidateBar</name>
    <message>
      <source>Another back …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άλλη πίσω όψη …</translation>
    </message>
    <message>
      <source>rim %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ακμή %1</translation>
    </message>
    <message>
      <source>no rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χωρίς ακμή</translation>
    </message>
    <message>
      <source>%1, with %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, τώρα με το %2</translation>
    </message>
    <message>
      <source>%1   %2   %3
%4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1   %2   %3
%4</translation>
    </message>
    <message>
      <source>Candidate %1: %2, %3, %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υποψήφιο %1: %2, %3, %4</translation>
    </message>
    <message>
      <source>%1, nobody's</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, ελεύθερο</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureFoot</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάστημα</translation>
    </message>
    <message>
      <source>Typed, from a code reader, or from the bag's label laid under the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Με πληκτρολόγηση, από αναγνώστη κωδικών, ή από την ετικέτα της σακούλας κάτω από την κάμερα</translation>
    </message>
    <message>
      <source>More</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Περισσότερα</translation>
    </message>
    <message>
      <source>Import, another rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή, άλλη διάταξη</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureStation</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάστημα</translation>
    </message>
    <message>
      <source>%1 is in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 είναι στην ουρά.</translation>
    </message>
    <message numerus="yes">
      <source>%1: %n file(s) imported; it is in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1: εισήχθη %n αρχείο· είναι στην ουρά.</numerusform>
        <numerusform>%1: εισήχθησαν %n αρχεία· είναι στην ουρά.</numerusform>
      </translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εντάξει</translation>
    </message>
    <message>
      <source>The next thing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το επόμενο</translation>
    </message>
    <message>
      <source>Stop the table</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στάση τραπεζιού</translation>
    </message>
    <message>
      <source>Photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογράφιση ξανά</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή φωτογραφιών…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή σαρώσεων…</translation>
    </message>
    <message>
      <source>Another rig…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άλλη διάταξη…</translation>
    </message>
    <message>
      <source>Camera %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1</translation>
    </message>
    <message>
      <source>Capture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λήψη</translation>
    </message>
    <message>
      <source>Folder with front/ and back/ scans</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος με σαρώσεις front/ και back/</translation>
    </message>
    <message>
      <source>Folder of a batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος μιας παρτίδας</translation>
    </message>
    <message>
      <source>The picture is on its way.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα έρχεται.</translation>
    </message>
    <message>
      <source>Look at this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κοιτάξτε πρώτα αυτό</translation>
    </message>
    <message>
      <source>R</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>R</translation>
    </message>
    <message>
      <source>does not answer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>δεν απαντά</translation>
    </message>
    <message>
      <source>%1 The desktop holds a camera, by its program %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Η επιφάνεια εργασίας κρατά μια κάμερα, με το πρόγραμμά της %2.</translation>
    </message>
    <message>
      <source>Type the sherds' numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πληκτρολόγηση των αριθμών των οστράκων</translation>
    </message>
    <message>
      <source>Say how many sherds lie there</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δήλωση του αριθμού των οστράκων</translation>
    </message>
    <message>
      <source>This project photographs with no calibrated rig of its own.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το έργο δεν φωτογραφίζει με δική του βαθμονομημένη διάταξη.</translation>
    </message>
    <message>
      <source>The rig is calibrated by %1; the calibration before is kept as %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάταξη βαθμονομήθηκε από το %1· η προηγούμενη φυλάσσεται ως %2.</translation>
    </message>
    <message>
      <source>The import is stopped; nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εισαγωγή διακόπηκε· δεν έμεινε τίποτα.</translation>
    </message>
    <message>
      <source>Import them all the same</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή παρ’ όλα αυτά</translation>
    </message>
    <message>
      <source>%1 has these files already; nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 έχει ήδη αυτά τα αρχεία· τίποτα δεν εισήχθη.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureWizard</name>
    <message>
      <source>Opening the rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άνοιγμα της διάταξης</translation>
    </message>
    <message>
      <source>%1 goes on where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 συνεχίζει από εκεί που ήταν.</translation>
    </message>
    <message>
      <source>Photographs of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες του %1</translation>
    </message>
    <message>
      <source>Press the shutter of camera %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πατήστε το κλείστρο της κάμερας %1.</translation>
    </message>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are safe.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Η φωτογραφία αυτής της όψης είναι ασφαλής.</numerusform>
        <numerusform>Οι %n φωτογραφίες αυτής της όψης είναι ασφαλείς.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 at stop %2: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1, στάση %2: %3</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>Live picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ζωντανή εικόνα</translation>
    </message>
    <message>
      <source>Front picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνα μπροστινών όψεων</translation>
    </message>
    <message>
      <source>No rig yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει ακόμη διάταξη</translation>
    </message>
    <message>
      <source>The rig is being opened</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάταξη ανοίγει</translation>
    </message>
    <message>
      <source>Lay the sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τοποθετήστε τα όστρακα στον δίσκο</translation>
    </message>
    <message>
      <source>Stopped</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σταμάτησε</translation>
    </message>
    <message>
      <source>Photographing the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογράφιση μπροστινών όψεων</translation>
    </message>
    <message>
      <source>Turn each sherd over where it lies</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Γυρίστε κάθε όστρακο στη θέση του</translation>
    </message>
    <message>
      <source>Photographing the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογράφιση πίσω όψεων</translation>
    </message>
    <message>
      <source>You may clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπορείτε να αδειάσετε τον δίσκο.</translation>
    </message>
    <message>
      <source>Look at the plate before you clear it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κοιτάξτε τον δίσκο πριν τον αδειάσετε</translation>
    </message>
    <message>
      <source>Fronts up, a finger's width apart, the marks at the edge of the plate free.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπροστινή όψη επάνω, απόσταση ενός δακτύλου, τα σημάδια στο χείλος ελεύθερα.</translation>
    </message>
    <message>
      <source>Hands off the table. Esc stops it at once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μακριά τα χέρια από το τραπέζι. Το Esc το σταματά αμέσως.</translation>
    </message>
    <message>
      <source>Shifting is fine, swapping is fine, losing one is not.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μετακίνηση και η αλλαγή θέσης επιτρέπονται, η απώλεια όχι.</translation>
    </message>
    <message>
      <source>%1 is in the queue; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 είναι στην ουρά· η επόμενη παρτίδα απέχει ένα πλήκτρο.</translation>
    </message>
    <message>
      <source>Space goes on all the same, R photographs the backs again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το διάστημα συνεχίζει έτσι κι αλλιώς, το R φωτογραφίζει ξανά τις πίσω όψεις.</translation>
    </message>
    <message>
      <source>Done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έγινε</translation>
    </message>
    <message>
      <source>Try again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμή ξανά</translation>
    </message>
    <message>
      <source>Shoot the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογράφιση μπροστινών όψεων</translation>
    </message>
    <message>
      <source>All turned: shoot the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλα γύρισαν: φωτογράφιση πίσω όψεων</translation>
    </message>
    <message>
      <source>Next batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επόμενη παρτίδα</translation>
    </message>
    <message>
      <source>It is right: into the queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Είναι σωστό: στην ουρά</translation>
    </message>
    <message>
      <source>Stop %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στάση %1 από %2</translation>
    </message>
    <message>
      <source>One moment</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια στιγμή</translation>
    </message>
    <message numerus="yes">
      <source>Front: %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Μπροστά: %n όστρακο</numerusform>
        <numerusform>Μπροστά: %n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>Front: %1 sherds, now %2 are seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπροστά: %1 όστρακα, τώρα φαίνονται %2</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπροστά %1, πίσω %2</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) are safe</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n φωτογραφία είναι ασφαλής</numerusform>
        <numerusform>%n φωτογραφίες είναι ασφαλείς</numerusform>
      </translation>
    </message>
    <message>
      <source>This camera shows no live picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η κάμερα δεν δείχνει ζωντανή εικόνα.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Φαίνεται %n όστρακο</numerusform>
        <numerusform>Φαίνονται %n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 may be two sherds, too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 ίσως είναι δύο όστρακα πολύ κοντά</translation>
    </message>
    <message>
      <source>%1 and %2 lie too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα %1 και %2 είναι πολύ κοντά</translation>
    </message>
    <message>
      <source>%1 reaches out of the picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 βγαίνει από την εικόνα</translation>
    </message>
    <message>
      <source>Marks %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σημάδια %1 από %2</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too dark</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 % των οστράκων είναι πολύ σκοτεινό</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too bright</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 % των οστράκων είναι πολύ φωτεινό</translation>
    </message>
    <message>
      <source>Light is right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το φως είναι σωστό</translation>
    </message>
    <message>
      <source>Read from the label: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Από την ετικέτα: %1</translation>
    </message>
    <message>
      <source>No room for more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν χωρά άλλο</translation>
    </message>
    <message numerus="yes">
      <source>Room for about %n more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Χωρά περίπου %n ακόμη</numerusform>
        <numerusform>Χωρούν περίπου %n ακόμη</numerusform>
      </translation>
    </message>
    <message>
      <source>Looking for what holds the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναζήτηση του τι κρατά την κάμερα</translation>
    </message>
    <message>
      <source>Making the desktop let go of the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η επιφάνεια εργασίας αφήνει την κάμερα</translation>
    </message>
    <message>
      <source>Make the desktop let go</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Απελευθέρωση της κάμερας</translation>
    </message>
    <message>
      <source>You counted %1 sherds, the photographs show %2: look for one that hides, touches another or was never laid down.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρήσατε %1 όστρακα, οι φωτογραφίες δείχνουν %2: ψάξτε ένα που κρύβεται, αγγίζει άλλο ή δεν τοποθετήθηκε.</translation>
    </message>
    <message>
      <source>You counted %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρήσατε %1</translation>
    </message>
    <message>
      <source>Marks %1 of %2, %3 are needed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σημάδια %1 από %2, χρειάζονται %3</translation>
    </message>
    <message>
      <source>Its sherds stand in the review (Ctrl+3): look while they still lie here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα όστρακά της είναι στον έλεγχο (Ctrl+3): δείτε τα όσο είναι ακόμη εδώ</translation>
    </message>
    <message>
      <source>The table stands still. What is safe is not photographed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τραπέζι είναι ακίνητο. Ό,τι είναι ασφαλές δεν φωτογραφίζεται ξανά.</translation>
    </message>
    <message>
      <source>Go on at stop %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Συνέχεια στη στάση %1</translation>
    </message>
    <message>
      <source>%1 was interrupted in the middle of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 διακόπηκε στη μέση αυτής της πλευράς.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CatalogueStation</name>
    <message numerus="yes">
      <source>change %1 of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>αλλαγή: %1, %n όστρακο</numerusform>
        <numerusform>αλλαγή: %1, %n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>Catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κατάλογος</translation>
    </message>
    <message>
      <source>Export these</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εξαγωγή αυτών</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα αρχικά σας</translation>
    </message>
    <message>
      <source>Who is working? Your initials go into the history:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ποιος εργάζεται; Τα αρχικά σας μπαίνουν στο ιστορικό:</translation>
    </message>
    <message>
      <source>Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα</translation>
    </message>
    <message>
      <source>Search</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναζήτηση</translation>
    </message>
    <message>
      <source>Edit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επεξεργασία</translation>
    </message>
    <message>
      <source>Give numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρίθμηση</translation>
    </message>
    <message>
      <source>No sherds yet. They come by themselves when a batch is computed; start with Capture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχουν ακόμη όστρακα. Έρχονται μόνα τους όταν υπολογιστεί μια παρτίδα· αρχίστε από τη Λήψη.</translation>
    </message>
    <message>
      <source>No sherd fits. Take a condition away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κανένα όστρακο δεν ταιριάζει. Αφαιρέστε έναν όρο.</translation>
    </message>
    <message>
      <source>change %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αλλαγή: %1</translation>
    </message>
    <message>
      <source>move to another context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μεταφορά σε άλλο πλαίσιο</translation>
    </message>
    <message>
      <source>changes by the import of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αλλαγές από την εισαγωγή του %1</translation>
    </message>
    <message>
      <source>Imported %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή του %1: %2</translation>
    </message>
    <message>
      <source>Import …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή …</translation>
    </message>
    <message>
      <source>Numbers, contexts and descriptions from a table, or an export (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμοί, πλαίσια και περιγραφές από πίνακα, ή μια εξαγωγή (%1)</translation>
    </message>
    <message>
      <source>About what is chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Για τα επιλεγμένα</translation>
    </message>
    <message>
      <source>Details</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στοιχεία</translation>
    </message>
    <message>
      <source>Drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σχέδιο</translation>
    </message>
    <message>
      <source>Details or drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στοιχεία ή σχέδιο</translation>
    </message>
    <message>
      <source>enter the rim's diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>καταχώριση διαμέτρου χείλους</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή</translation>
    </message>
    <message>
      <source>The import of %1 broke off after %2 of %3 rows; these are whole. Import it again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εισαγωγή του %1 διακόπηκε μετά από %2 από %3 γραμμές· αυτές είναι πλήρεις. Εισαγάγετε ξανά για τα υπόλοιπα.</translation>
    </message>
    <message>
      <source>Do not tell this again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Να μην αναφερθεί ξανά</translation>
    </message>
    <message>
      <source>Choose the sherds that are to get numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλέξτε τα όστρακα που θα πάρουν αριθμό.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::DrawingPage</name>
    <message>
      <source>Scale of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα του σχεδίου</translation>
    </message>
    <message>
      <source>1 : 1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 1</translation>
    </message>
    <message>
      <source>1 : 2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 2</translation>
    </message>
    <message>
      <source>How surfaces are drawn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πώς σχεδιάζονται οι επιφάνειες</translation>
    </message>
    <message>
      <source>Light and shade of the form</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φως και σκιά της μορφής</translation>
    </message>
    <message>
      <source>With paint and slip</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Με γραπτή διακόσμηση και επίχρισμα</translation>
    </message>
    <message>
      <source>Whether it is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αν είναι χείλος</translation>
    </message>
    <message>
      <source>As the parts say, or as is likely</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όπως λένε τα μέρη, ή όπως είναι πιθανό</translation>
    </message>
    <message>
      <source>It is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Είναι χείλος</translation>
    </message>
    <message>
      <source>It is no rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι χείλος</translation>
    </message>
    <message>
      <source>Scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα</translation>
    </message>
    <message>
      <source>Surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιφάνεια</translation>
    </message>
    <message>
      <source>Rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χείλος</translation>
    </message>
    <message>
      <source>Enter the diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καταχώριση διαμέτρου</translation>
    </message>
    <message>
      <source>Save …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθήκευση …</translation>
    </message>
    <message>
      <source>Print …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση …</translation>
    </message>
    <message>
      <source>Print the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση του σχεδίου</translation>
    </message>
    <message>
      <source>Progress of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος του σχεδίου</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή</translation>
    </message>
    <message>
      <source>The sheet before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το προηγούμενο φύλλο</translation>
    </message>
    <message>
      <source>The next sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το επόμενο φύλλο</translation>
    </message>
    <message>
      <source>What the drawing says</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι λέει το σχέδιο</translation>
    </message>
    <message>
      <source>Drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σχέδια</translation>
    </message>
    <message>
      <source>Stopped; nothing was drawn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σταμάτησε· δεν σχεδιάστηκε τίποτα.</translation>
    </message>
    <message>
      <source>A sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα φύλλο</translation>
    </message>
    <message numerus="yes">
      <source>Drawing %n sherd(s) …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Σχεδίαση %n οστράκου …</numerusform>
        <numerusform>Σχεδίαση %n οστράκων …</numerusform>
      </translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλέξτε όστρακο.</translation>
    </message>
    <message>
      <source>Mouth %1 cm across (95 %: %2 to %3), %4 % of the rim kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στόμιο %1 cm (95 %: %2 έως %3), σώζεται το %4 % του χείλους.</translation>
    </message>
    <message>
      <source>Mouth %1 cm across (95 %: above %2), %3 % of the rim kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στόμιο %1 cm (95 %: πάνω από %2), σώζεται το %3 % του χείλους.</translation>
    </message>
    <message>
      <source>%1 drawn, %2 left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σχεδιάστηκαν %1, παραλείφθηκαν %2.</translation>
    </message>
    <message numerus="yes">
      <source>Draw plates of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Πίνακες %n οστράκου</numerusform>
        <numerusform>Πίνακες %n οστράκων</numerusform>
      </translation>
    </message>
    <message>
      <source>Sheet %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φύλλο %1 από %2</translation>
    </message>
    <message>
      <source>plates</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίνακες</translation>
    </message>
    <message>
      <source>Save the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθήκευση του σχεδίου</translation>
    </message>
    <message>
      <source>PDF, all sheets (*.pdf);;SVG, a file each sheet (*.svg)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PDF, όλα τα φύλλα (*.pdf);;SVG, ένα αρχείο ανά φύλλο (*.svg)</translation>
    </message>
    <message>
      <source>Saving a drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθήκευση σχεδίου</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε: %1</translation>
    </message>
    <message>
      <source>Printing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση</translation>
    </message>
    <message>
      <source>The drawing is sent to the printer; print it at 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το σχέδιο στέλνεται στον εκτυπωτή· τυπώστε το στο 100 %.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportModel</name>
    <message>
      <source>Size of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μέγεθος της εξαγωγής</translation>
    </message>
    <message>
      <source>Counting …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μέτρηση …</translation>
    </message>
    <message>
      <source>No sherd fits; choose others.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κανένα όστρακο δεν ταιριάζει· επιλέξτε άλλα.</translation>
    </message>
    <message>
      <source>less than a minute</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>λιγότερο από ένα λεπτό</translation>
    </message>
    <message numerus="yes">
      <source>about %n minute(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>περίπου %n λεπτό</numerusform>
        <numerusform>περίπου %n λεπτά</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1 files, %2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο, %1 αρχεία, %2, %3</numerusform>
        <numerusform>%n όστρακα, %1 αρχεία, %2, %3</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n από αυτά χωρίς μοντέλο</numerusform>
        <numerusform>%n από αυτά χωρίς μοντέλο</numerusform>
      </translation>
    </message>
    <message>
      <source>There is a folder of this name already; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη φάκελος με αυτό το όνομα· επιλέξτε άλλο όνομα.</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message numerus="yes">
      <source>%1, %n second(s) left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1, μένει %n δευτερόλεπτο</numerusform>
        <numerusform>%1, μένουν %n δευτερόλεπτα</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1, manifest checked</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο, %1, ο κατάλογος αρχείων ελέγχθηκε</numerusform>
        <numerusform>%n όστρακα, %1, ο κατάλογος αρχείων ελέγχθηκε</numerusform>
      </translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εξαγωγή</translation>
    </message>
    <message>
      <source>Stopped; nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σταμάτησε· δεν έμεινε τίποτα πίσω.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportStation</name>
    <message>
      <source>Exported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εξαγωγή έγινε: %1</translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εξαγωγή</translation>
    </message>
    <message>
      <source>What</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι</translation>
    </message>
    <message>
      <source>All sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλα τα όστρακα</translation>
    </message>
    <message>
      <source>Those that fit this filter:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όσα ταιριάζουν σε αυτό το φίλτρο:</translation>
    </message>
    <message>
      <source>Filter of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φίλτρο της εξαγωγής</translation>
    </message>
    <message>
      <source>context:0012</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>context:0012</translation>
    </message>
    <message>
      <source>Forms</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μορφές</translation>
    </message>
    <message>
      <source>Tables (CSV), for spreadsheets</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίνακες (CSV), για λογιστικά φύλλα</translation>
    </message>
    <message>
      <source>Records (JSON), to be read back whole</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εγγραφές (JSON), που διαβάζονται πάλι ολόκληρες</translation>
    </message>
    <message>
      <source>A picture of each model (PNG)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια εικόνα κάθε μοντέλου (PNG)</translation>
    </message>
    <message>
      <source>Models as PLY, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μοντέλα ως PLY, σε mm</translation>
    </message>
    <message>
      <source>Models as GLB, for the web and for slides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μοντέλα ως GLB, για τον ιστό και παρουσιάσεις</translation>
    </message>
    <message>
      <source>Models as OBJ, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μοντέλα ως OBJ, σε mm</translation>
    </message>
    <message>
      <source>The photographs, unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι φωτογραφίες, αμετάβλητες</translation>
    </message>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πού</translation>
    </message>
    <message>
      <source>New folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέος φάκελος για την εξαγωγή</translation>
    </message>
    <message>
      <source>Choose …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλογή …</translation>
    </message>
    <message>
      <source>Progress of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος της εξαγωγής</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή</translation>
    </message>
    <message>
      <source>Open folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άνοιγμα φακέλου</translation>
    </message>
    <message>
      <source>Where shall the folder be?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πού να είναι ο φάκελος;</translation>
    </message>
    <message>
      <source>Those chosen in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα επιλεγμένα στον κατάλογο</translation>
    </message>
    <message numerus="yes">
      <source>The %n chosen in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Το επιλεγμένο στον κατάλογο</numerusform>
        <numerusform>Τα %n επιλεγμένα στον κατάλογο</numerusform>
      </translation>
    </message>
    <message>
      <source>Drawings for print (SVG and PDF)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σχέδια για εκτύπωση (SVG και PDF)</translation>
    </message>
    <message>
      <source>Scale of the drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα των σχεδίων</translation>
    </message>
    <message>
      <source>1 : 1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 1</translation>
    </message>
    <message>
      <source>1 : 2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 2</translation>
    </message>
    <message>
      <source>as fits A4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όπως χωρά σε A4</translation>
    </message>
    <message>
      <source>Tables (ODS): LibreOffice, Excel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίνακες (ODS): LibreOffice, Excel</translation>
    </message>
    <message>
      <source>Pictures, masks, poses for COLMAP and OpenMVS</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνες, μάσκες, θέσεις για COLMAP και OpenMVS</translation>
    </message>
    <message>
      <source>Detail of the models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λεπτομέρεια των μοντέλων</translation>
    </message>
    <message>
      <source>Of PLY, GLB and OBJ: with fewer triangles the files are a fraction as large. How far they are off is measured and stated in each.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Για PLY, GLB και OBJ: με λιγότερα τρίγωνα τα αρχεία είναι πολύ μικρότερα. Η απόκλισή τους μετριέται και γράφεται σε καθένα.</translation>
    </message>
    <message>
      <source>as computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όπως υπολογίστηκαν</translation>
    </message>
    <message>
      <source>lighter, to %1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ελαφρύτερα, έως %1 mm</translation>
    </message>
    <message>
      <source>Stop the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή της εξαγωγής</translation>
    </message>
    <message>
      <source>Export: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εξαγωγή: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::FilterLine</name>
    <message>
      <source>Filter of the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φίλτρο του καταλόγου</translation>
    </message>
    <message>
      <source>rim T3 thickness&gt;6</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rim T3 thickness&gt;6</translation>
    </message>
    <message>
      <source>Words are looked for everywhere; ware:grey, thickness&gt;6, -burnt, note:* also work.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι λέξεις αναζητούνται παντού· ισχύουν και τα ware:grey, thickness&gt;6, -burnt, note:*.</translation>
    </message>
    <message>
      <source>Take away the condition %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αφαίρεση του όρου %1</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο</numerusform>
        <numerusform>%n όστρακα</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::FooterLine</name>
    <message>
      <source>What the computer does</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι κάνει ο υπολογιστής</translation>
    </message>
    <message>
      <source>What was done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι έγινε</translation>
    </message>
    <message>
      <source>Progress of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος του υπολογισμού</translation>
    </message>
    <message>
      <source>Nothing to compute</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τίποτα για υπολογισμό</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::HeaderLine</name>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πού</translation>
    </message>
    <message>
      <source>Rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάταξη</translation>
    </message>
    <message>
      <source>Room on the disk</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χώρος στον δίσκο</translation>
    </message>
    <message>
      <source>Rig: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάταξη: %1</translation>
    </message>
    <message numerus="yes">
      <source>Disk: room for %n batch(es)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Δίσκος: χώρος για %n παρτίδα</numerusform>
        <numerusform>Δίσκος: χώρος για %n παρτίδες</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::HelpPage</name>
    <message>
      <source>Manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εγχειρίδιο</translation>
    </message>
    <message>
      <source>&amp;Contents</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Περιεχόμενα</translation>
    </message>
    <message>
      <source>All &amp;keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλα τα π&amp;λήκτρα</translation>
    </message>
    <message>
      <source>&amp;About</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Σχετικά</translation>
    </message>
    <message>
      <source>Back to work (Esc)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίσω στη δουλειά (Esc)</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλα τα πλήκτρα</translation>
    </message>
    <message>
      <source>Complete, measured 3D models of potsherds from photographs of both their sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πλήρη, μετρημένα τρισδιάστατα μοντέλα οστράκων από φωτογραφίες και των δύο όψεών τους.</translation>
    </message>
    <message>
      <source>Apache License 2.0. It uses Qt (LGPL 3), VTK and OpenCV among others; the file LICENSE and the README name them all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άδεια Apache 2.0. Χρησιμοποιεί μεταξύ άλλων Qt (LGPL 3), VTK και OpenCV· το αρχείο LICENSE και το README τα αναφέρουν όλα.</translation>
    </message>
    <message>
      <source>Nothing leaves this computer: there is no network in it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τίποτα δεν φεύγει από αυτόν τον υπολογιστή: δεν έχει δίκτυο μέσα.</translation>
    </message>
    <message>
      <source>The manual is in English.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το εγχειρίδιο υπάρχει μόνο στα αγγλικά.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportDialog</name>
    <message>
      <source>new</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>νέο</translation>
    </message>
    <message>
      <source>changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>άλλαξε</translation>
    </message>
    <message>
      <source>refused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>απορρίφθηκε</translation>
    </message>
    <message>
      <source>as it is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ως έχει</translation>
    </message>
    <message>
      <source>Import into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή στον κατάλογο</translation>
    </message>
    <message>
      <source>A table (CSV) …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας πίνακας (CSV) …</translation>
    </message>
    <message>
      <source>An export folder …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας φάκελος εξαγωγής …</translation>
    </message>
    <message>
      <source>Make sites, trenches, contexts and bags that are not there yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δημιουργία θέσεων, τομών, πλαισίων και σακουλών που λείπουν</translation>
    </message>
    <message>
      <source>What each row would do</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι θα έκανε κάθε γραμμή</translation>
    </message>
    <message>
      <source>Progress of the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος της εισαγωγής</translation>
    </message>
    <message>
      <source>Save what is refused …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθήκευση όσων απορρίφθηκαν …</translation>
    </message>
    <message>
      <source>Which table?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ποιος πίνακας;</translation>
    </message>
    <message>
      <source>Tables (*.csv *.tsv *.txt);;All (*)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίνακες (*.csv *.tsv *.txt);;Όλα (*)</translation>
    </message>
    <message>
      <source>Which export?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ποια εξαγωγή;</translation>
    </message>
    <message>
      <source>Save what is refused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθήκευση όσων απορρίφθηκαν</translation>
    </message>
    <message>
      <source>refused.csv</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>refused.csv</translation>
    </message>
    <message>
      <source>Tables (*.csv)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίνακες (*.csv)</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε: %1</translation>
    </message>
    <message>
      <source>line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>γραμμή</translation>
    </message>
    <message>
      <source>what happens</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τι γίνεται</translation>
    </message>
    <message>
      <source>why not</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>γιατί όχι</translation>
    </message>
    <message>
      <source>A table of sherds has a column number or uuid; one of contexts has site, context and, if you like, trench and bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας πίνακας οστράκων έχει στήλη number ή uuid· ένας πλαισίων έχει site, context και, αν θέλετε, trench και bag.</translation>
    </message>
    <message>
      <source>Looking at it …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εξέταση …</translation>
    </message>
    <message>
      <source>Entered: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καταχωρίστηκαν: %1</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλείσιμο</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή</translation>
    </message>
    <message>
      <source>Take nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία καταχώριση</translation>
    </message>
    <message numerus="yes">
      <source>Enter %n row(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Καταχώριση %n γραμμής</numerusform>
        <numerusform>Καταχώριση %n γραμμών</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportModel</name>
    <message>
      <source>%1 '%2': %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 «%2»: %3</translation>
    </message>
    <message>
      <source>Preview of an import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Προεπισκόπηση εισαγωγής</translation>
    </message>
    <message>
      <source>%1 new, %2 changed, %3 as they are, %4 refused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 νέα, %2 άλλαξαν, %3 ως έχουν, %4 απορρίφθηκαν.</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή</translation>
    </message>
    <message>
      <source>Stopped; nothing was entered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σταμάτησε· δεν καταχωρίστηκε τίποτα.</translation>
    </message>
    <message numerus="yes">
      <source>Stopped: %n row(s) are not entered. Import the table again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Σταμάτησε: %n γραμμή δεν καταχωρήθηκε. Εισαγάγετε ξανά τον πίνακα για τα υπόλοιπα.</numerusform>
        <numerusform>Σταμάτησε: %n γραμμές δεν καταχωρήθηκαν. Εισαγάγετε ξανά τον πίνακα για τα υπόλοιπα.</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::JoinMode</name>
    <message>
      <source>Which back belongs to the one of %1? Choose its card (arrows and Enter).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ποια πίσω όψη ανήκει σε εκείνη του %1; Επιλέξτε την κάρτα της (βέλη και Enter).</translation>
    </message>
    <message>
      <source>Which front belongs to the one of %1? Choose its card (arrows and Enter); a click on a back's picture joins the backs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ποια μπροστινή όψη ανήκει σε εκείνη του %1; Επιλέξτε την κάρτα της (βέλη και Enter)· ένα κλικ στην εικόνα μιας πίσω όψης ενώνει τις πίσω.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MainWindow</name>
    <message>
      <source>Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka</translation>
    </message>
    <message>
      <source>%1 is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 υπολογίστηκε.</translation>
    </message>
    <message>
      <source>%1 stopped: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 σταμάτησε: %2</translation>
    </message>
    <message>
      <source>Undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναίρεση</translation>
    </message>
    <message>
      <source>Do again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επανάληψη</translation>
    </message>
    <message>
      <source>Manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εγχειρίδιο</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλα τα πλήκτρα</translation>
    </message>
    <message>
      <source>Other projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άλλα έργα</translation>
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έργα</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ρυθμίσεις</translation>
    </message>
    <message>
      <source>Help</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Βοήθεια</translation>
    </message>
    <message>
      <source>Back to work</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίσω στη δουλειά</translation>
    </message>
    <message>
      <source>This project is open in another window already: go on there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το έργο είναι ήδη ανοιχτό σε άλλο παράθυρο: συνεχίστε εκεί.</translation>
    </message>
    <message>
      <source>%1 - Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 - Ostraka</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικονική διάταξη</translation>
    </message>
    <message>
      <source>Virtual rig %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικονική διάταξη %1</translation>
    </message>
    <message>
      <source>Everywhere</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παντού</translation>
    </message>
    <message>
      <source>Room on the disk</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χώρος στον δίσκο</translation>
    </message>
    <message>
      <source>The computation is being stopped; it goes on when the project is opened again. The window closes in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο υπολογισμός σταματά· συνεχίζει όταν ανοίξει ξανά το έργο. Το παράθυρο κλείνει σε λίγο.</translation>
    </message>
    <message>
      <source>Queue: mending masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ουρά: διόρθωση μασκών</translation>
    </message>
    <message>
      <source>Undo: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναίρεση: %1</translation>
    </message>
    <message>
      <source>Do again: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επανάληψη: %1</translation>
    </message>
    <message>
      <source>Copy of the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αντίγραφο του καταλόγου</translation>
    </message>
    <message>
      <source>The catalogue could not be copied: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κατάλογος δεν αντιγράφηκε: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MapStation</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδα</translation>
    </message>
    <message>
      <source>Print map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση χάρτη και ετικετών</translation>
    </message>
    <message>
      <source>Print map and labels   Ctrl+P</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση χάρτη και ετικετών   Ctrl+P</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο %1</translation>
    </message>
    <message>
      <source>No batch is computed yet; its map appears here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπολογίστηκε ακόμη παρτίδα· ο χάρτης της εμφανίζεται εδώ.</translation>
    </message>
    <message>
      <source>Map of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χάρτης της %1</translation>
    </message>
    <message>
      <source>%1-%2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-%2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδα %1</translation>
    </message>
    <message>
      <source>Batch %1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδα %1, %2</translation>
    </message>
    <message>
      <source>Map and labels are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο χάρτης και οι ετικέτες στέλνονται στον εκτυπωτή.</translation>
    </message>
    <message>
      <source>Map</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χάρτης</translation>
    </message>
    <message>
      <source>Print bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση ετικετών σακουλών</translation>
    </message>
    <message>
      <source>Bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ετικέτες σακουλών</translation>
    </message>
    <message>
      <source>Print a label for each bag; its code gives a batch its context (Ctrl+Shift+P)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση ετικέτας για κάθε σακούλα· ο κωδικός της δίνει στην παρτίδα το πλαίσιό της (Ctrl+Shift+P)</translation>
    </message>
    <message>
      <source>There is no bag yet: type one at the capture, or import a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει ακόμη σακούλα: πληκτρολογήστε μία στη λήψη ή εισαγάγετε πίνακα πλαισίων.</translation>
    </message>
    <message numerus="yes">
      <source>%n label(s) are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n ετικέτα στάλθηκε στον εκτυπωτή.</numerusform>
        <numerusform>%n ετικέτες στάλθηκαν στον εκτυπωτή.</numerusform>
      </translation>
    </message>
    <message>
      <source>This batch was scanned, not photographed: there is no picture of its plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η παρτίδα σαρώθηκε, δεν φωτογραφήθηκε: δεν υπάρχει εικόνα του δίσκου της.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) of this batch have no number yet: their labels name the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο αυτής της παρτίδας δεν έχει ακόμη αριθμό: η ετικέτα του γράφει την παρτίδα.</numerusform>
        <numerusform>%n όστρακα αυτής της παρτίδας δεν έχουν ακόμη αριθμό: οι ετικέτες τους γράφουν την παρτίδα.</numerusform>
      </translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MapView</name>
    <message>
      <source>Plate, front and back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δίσκος, μπροστά και πίσω</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο %1</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μπροστινή όψη</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω όψη</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MessagePanel</name>
    <message>
      <source>What happened</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι συνέβη</translation>
    </message>
    <message>
      <source>Leave it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άφησέ το</translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εντάξει</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ModelPane</name>
    <message>
      <source>Picture of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνα του οστράκου</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τομή</translation>
    </message>
    <message>
      <source>Cut the model open; Shift and the wheel move the plane</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τομή του μοντέλου· το Shift και ο τροχός μετακινούν το επίπεδο</translation>
    </message>
    <message>
      <source>From above</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Από πάνω</translation>
    </message>
    <message>
      <source>Picture of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνα ενός οστράκου</translation>
    </message>
    <message>
      <source>Model of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μοντέλο ενός οστράκου</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NewProject</name>
    <message>
      <source>The site's code has two to eight capital letters and digits, like ARM1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κωδικός της θέσης έχει δύο έως οκτώ κεφαλαία και ψηφία, όπως ARM1.</translation>
    </message>
    <message>
      <source>Choose a folder for the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλέξτε φάκελο για το έργο.</translation>
    </message>
    <message>
      <source>There is a project in this folder already: open it, or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη έργο σε αυτόν τον φάκελο: ανοίξτε το, ή επιλέξτε άλλον.</translation>
    </message>
    <message>
      <source>This folder holds other files: choose a new one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος έχει άλλα αρχεία: επιλέξτε νέο.</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικονική διάταξη</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::OutlinePlot</name>
    <message>
      <source>Outlines laid over each other, and their turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Περιγράμματα το ένα πάνω στο άλλο, και οι γωνίες στροφής τους</translation>
    </message>
    <message>
      <source>The turning angles differ by %1 rad.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι γωνίες στροφής διαφέρουν κατά %1 rad.</translation>
    </message>
    <message>
      <source>outlines on each other</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>περιγράμματα μαζί</translation>
    </message>
    <message>
      <source>turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>γωνίες στροφής</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>differ by %1 rad</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διαφορά %1 rad</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PairReviewModel</name>
    <message>
      <source>Small pictures of the sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μικρές εικόνες των οστράκων</translation>
    </message>
    <message>
      <source>%1, %2. %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2. %3</translation>
    </message>
    <message>
      <source>No back is chosen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν επιλέχθηκε πίσω όψη.</translation>
    </message>
    <message>
      <source>The rims do not meet here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι ακμές δεν συναντιούνται εδώ.</translation>
    </message>
    <message>
      <source>Rims %1 apart, %2 of them meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακμές σε απόσταση %1, συναντιέται το %2.</translation>
    </message>
    <message>
      <source>Turned by hand; B lets the rims settle it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στράφηκε με το χέρι· το B αφήνει τις ακμές να το ρυθμίσουν.</translation>
    </message>
    <message>
      <source>Start point %1; B lets the rims settle it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρχικό σημείο %1· το B αφήνει τις ακμές να το ρυθμίσουν.</translation>
    </message>
    <message>
      <source>Choose a back first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλέξτε πρώτα πίσω όψη.</translation>
    </message>
    <message>
      <source>Enter your initials first: each decision keeps its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Γράψτε πρώτα τα αρχικά σας: κάθε απόφαση κρατά το όνομά της.</translation>
    </message>
    <message>
      <source>choice of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>επιλογή του %1</translation>
    </message>
    <message>
      <source>Comparing two sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σύγκριση δύο όψεων</translation>
    </message>
    <message>
      <source>pair %1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ζεύγος %1 – %2</translation>
    </message>
    <message>
      <source>setting aside %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το %1 στην άκρη</translation>
    </message>
    <message>
      <source>shooting %1 again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>νέα λήψη του %1</translation>
    </message>
    <message>
      <source>One of the two has no back to be joined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το ένα από τα δύο δεν έχει πίσω όψη για ένωση.</translation>
    </message>
    <message>
      <source>joining %1 and %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ένωση των %1 και %2</translation>
    </message>
    <message>
      <source>cutting %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κόψιμο του %1</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχικό σημείο</translation>
    </message>
    <message>
      <source>settling by the rims</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ρύθμιση από τις ακμές</translation>
    </message>
    <message>
      <source>turning by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>στροφή με το χέρι</translation>
    </message>
    <message>
      <source>Closed model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλειστό μοντέλο</translation>
    </message>
    <message>
      <source>This pair has no closed model yet; it is made when the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το ζεύγος δεν έχει ακόμη κλειστό μοντέλο· γίνεται όταν υπολογιστεί η παρτίδα.</translation>
    </message>
    <message>
      <source>Picture of a pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνα ενός ζεύγους</translation>
    </message>
    <message>
      <source>More candidates</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Περισσότερα υποψήφια</translation>
    </message>
    <message>
      <source>This back lies alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η πίσω όψη είναι μόνη.</translation>
    </message>
    <message>
      <source>No pair is chosen: give this back to a front first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν επιλέχθηκε ζεύγος: δώστε πρώτα αυτή την πίσω όψη σε μια μπροστινή.</translation>
    </message>
    <message>
      <source>A back alone has no closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια πίσω όψη μόνη δεν έχει κλειστό μοντέλο.</translation>
    </message>
    <message>
      <source>Stopped; the back stays where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακόπηκε· η πίσω πλευρά μένει όπου ήταν.</translation>
    </message>
    <message>
      <source>What was only tried is gone: its pairs were closed since.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό,τι ήταν μόνο δοκιμή δεν υπάρχει πια· τα ζεύγη του έκλεισαν στο μεταξύ.</translation>
    </message>
    <message>
      <source>Saved, with your name; but the rims of %1 and %2 hardly meet: %3 of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε, με το όνομά σας· όμως οι ακμές του %1 και του %2 μόλις συναντιούνται: το %3.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PicturePair</name>
    <message>
      <source>Photographs of both sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες και των δύο όψεων</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπροστά %1, πίσω %2</translation>
    </message>
    <message>
      <source>The photograph is not there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η φωτογραφία λείπει.</translation>
    </message>
    <message>
      <source>front %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μπροστά %1</translation>
    </message>
    <message>
      <source>back %1, mirrored</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω %1, κατοπτρικά</translation>
    </message>
    <message>
      <source>back %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω %1</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>Line over the %1, %2 steps from its middle, turned by %3 degrees</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Γραμμή πάνω στο %1, %2 βήματα από το μέσο, στραμμένη κατά %3 μοίρες</translation>
    </message>
    <message>
      <source>Arrows move the line, with Shift they turn it, Up or Down takes the other side, Enter cuts. Or draw a line with the mouse.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα βέλη μετακινούν τη γραμμή, με Shift τη στρέφουν, Πάνω ή Κάτω παίρνει την άλλη όψη, Enter κόβει. Ή σχεδιάστε γραμμή με το ποντίκι.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PlaceEdit</name>
    <message>
      <source>&amp;Bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Σακούλα</translation>
    </message>
    <message>
      <source>scan its label, or ARM1-T3-0012-4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σαρώστε την ετικέτα, ή ARM1-T3-0012-4</translation>
    </message>
    <message>
      <source>Site, trench, context and bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Θέση, τομή, πλαίσιο και σακούλα</translation>
    </message>
    <message>
      <source>no bag: no numbers yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χωρίς σακούλα: ακόμη χωρίς αριθμούς</translation>
    </message>
    <message>
      <source>site-trench-context-bag, please</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>θέση-τομή-πλαίσιο-σακούλα, παρακαλώ</translation>
    </message>
    <message>
      <source>New: %1 (Esc takes it back)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέα: %1 (το Esc τα αναιρεί)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PlateView</name>
    <message>
      <source>Picture of the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνα του δίσκου</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Φαίνεται %n όστρακο</numerusform>
        <numerusform>Φαίνονται %n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>5 cm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>5 εκ.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::QueueStation</name>
    <message>
      <source>Pause</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παύση</translation>
    </message>
    <message>
      <source>Compute again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέος υπολογισμός</translation>
    </message>
    <message>
      <source>Stop this batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή αυτής της παρτίδας</translation>
    </message>
    <message>
      <source>Report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναφορά</translation>
    </message>
    <message>
      <source>Review it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έλεγχός της</translation>
    </message>
    <message>
      <source>Log</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ημερολόγιο</translation>
    </message>
    <message>
      <source>Batches</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδες</translation>
    </message>
    <message>
      <source>Log of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ημερολόγιο υπολογισμού</translation>
    </message>
    <message>
      <source>No batch yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία παρτίδα ακόμη</translation>
    </message>
    <message>
      <source>What you photograph or import is computed here, one batch after the other, while you go on working.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό,τι φωτογραφίζετε ή εισάγετε υπολογίζεται εδώ, η μία παρτίδα μετά την άλλη, ενώ συνεχίζετε.</translation>
    </message>
    <message>
      <source>Photograph the first batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογράφιση της πρώτης παρτίδας</translation>
    </message>
    <message>
      <source>Queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ουρά</translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es) stopped and need you</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n παρτίδα σταμάτησε και σας χρειάζεται</numerusform>
        <numerusform>%n παρτίδες σταμάτησαν και σας χρειάζονται</numerusform>
      </translation>
    </message>
    <message>
      <source>Go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Συνέχεια</translation>
    </message>
    <message>
      <source>%1 has no report yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 δεν έχει ακόμη αναφορά.</translation>
    </message>
    <message>
      <source>Stop %1?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή της %1;</translation>
    </message>
    <message>
      <source>It has been computed for more than an hour. Whole stages are kept, the present one is lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπολογίζεται πάνω από μία ώρα. Τα ολοκληρωμένα στάδια κρατιούνται, το τωρινό χάνεται.</translation>
    </message>
    <message>
      <source>Stop it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή</translation>
    </message>
    <message>
      <source>Let it go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Να συνεχίσει</translation>
    </message>
    <message>
      <source>Mend the masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διόρθωση μασκών</translation>
    </message>
    <message>
      <source>Drafts first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρώτα προσχέδια</translation>
    </message>
    <message>
      <source>Computes each new batch quickly and coarsely, to be looked at while the sherds still lie there; computed again it becomes final (D)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπολογίζει κάθε νέα παρτίδα γρήγορα και χονδρικά, για να τη δείτε όσο τα όστρακα είναι ακόμη εκεί· αν υπολογιστεί ξανά γίνεται οριστική (D)</translation>
    </message>
    <message>
      <source>Calibrate the rig again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέα βαθμονόμηση της διάταξης</translation>
    </message>
    <message>
      <source>A camera was bumped: this batch's photographs tell where the cameras stand now (C)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια κάμερα μετακινήθηκε: οι φωτογραφίες της παρτίδας δείχνουν πού είναι τώρα (C)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Rail</name>
    <message>
      <source>Stations</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σταθμοί</translation>
    </message>
    <message>
      <source>%1  %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1  %2</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ReviewPane</name>
    <message>
      <source>Pairs, most doubtful first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ζεύγη, τα πιο αμφίβολα πρώτα</translation>
    </message>
    <message>
      <source>This one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό</translation>
    </message>
    <message>
      <source>Next pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επόμενο ζεύγος</translation>
    </message>
    <message>
      <source>Previous pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Προηγούμενο ζεύγος</translation>
    </message>
    <message>
      <source>Candidate %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υποψήφιο %1</translation>
    </message>
    <message>
      <source>Start point before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Προηγούμενο αρχικό σημείο</translation>
    </message>
    <message>
      <source>Next start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επόμενο αρχικό σημείο</translation>
    </message>
    <message>
      <source>One sample back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα δείγμα πίσω</translation>
    </message>
    <message>
      <source>One sample on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα δείγμα μπροστά</translation>
    </message>
    <message>
      <source>Mirror back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κατοπτρικά</translation>
    </message>
    <message>
      <source>Apart</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χωριστά</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τομή</translation>
    </message>
    <message>
      <source>Measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μέτρηση</translation>
    </message>
    <message>
      <source>Rim gap</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κενό ακμής</translation>
    </message>
    <message>
      <source>Model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μοντέλο</translation>
    </message>
    <message>
      <source>Settle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ρύθμιση</translation>
    </message>
    <message>
      <source>Let the rims settle the position (B)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι ακμές ρυθμίζουν τη θέση (B)</translation>
    </message>
    <message>
      <source>Set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στην άκρη</translation>
    </message>
    <message>
      <source>Shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέα λήψη</translation>
    </message>
    <message>
      <source>Cut</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κόψιμο</translation>
    </message>
    <message>
      <source>Join</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένωση</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>%1, key %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, πλήκτρο %2</translation>
    </message>
    <message>
      <source>This one   Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό   Enter</translation>
    </message>
    <message>
      <source>The rims are compared … Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σύγκριση των ακμών … Το Esc διακόπτει.</translation>
    </message>
    <message>
      <source>… and the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>… και το άλλο άκρο</translation>
    </message>
    <message>
      <source>Pairs of the batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ζεύγη της παρτίδας</translation>
    </message>
    <message>
      <source>Join two pieces of one sherd: then choose the other card (J fronts, Shift+J backs)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένωση δύο κομματιών ενός οστράκου: μετά επιλέξτε την άλλη κάρτα (J μπροστινές, Shift+J πίσω)</translation>
    </message>
    <message>
      <source>Join backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένωση πίσω όψεων</translation>
    </message>
    <message>
      <source>Settle, join and cut nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία προσαρμογή, ένωση ή κοπή</translation>
    </message>
    <message>
      <source>Cut a piece that is two sherds in truth, along a line over its picture (K)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κοπή κομματιού που στην πραγματικότητα είναι δύο όστρακα, κατά μήκος γραμμής πάνω στην εικόνα του (K)</translation>
    </message>
    <message>
      <source>The rims settle: %1. Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι ακμές προσαρμόζονται: %1. Το Esc διακόπτει.</translation>
    </message>
    <message>
      <source>Click on one end of the length on the sherd, then on the other. D ends.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάντε κλικ στο ένα άκρο του μήκους πάνω στο όστρακο, μετά στο άλλο. Το D τελειώνει.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ReviewStation</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδα</translation>
    </message>
    <message>
      <source>Your &amp;initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα &amp;αρχικά σας</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα αρχικά σας</translation>
    </message>
    <message>
      <source>Compute what changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπολογισμός των αλλαγών</translation>
    </message>
    <message>
      <source>Makes the models of the pairs that were decided anew</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φτιάχνει τα μοντέλα των ζευγών που αποφασίστηκαν ξανά</translation>
    </message>
    <message>
      <source>No batch is computed yet. Shoot or import one; its pairs appear here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπολογίστηκε ακόμη παρτίδα. Φωτογραφίστε ή εισαγάγετε μία· τα ζεύγη της εμφανίζονται εδώ.</translation>
    </message>
    <message>
      <source>Opening %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άνοιγμα της %1</translation>
    </message>
    <message>
      <source>%1 waits to be computed; only what changed is done again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 περιμένει υπολογισμό· ξαναγίνεται μόνο ό,τι άλλαξε.</translation>
    </message>
    <message>
      <source>Saved. The pairs of the new pieces come when it is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε. Τα ζεύγη των νέων κομματιών έρχονται με τον υπολογισμό.</translation>
    </message>
    <message>
      <source>Taken back. Both are kept in the history.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ανακλήθηκε. Και τα δύο μένουν στο ιστορικό.</translation>
    </message>
    <message>
      <source>Saved, with your name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε, με το όνομά σας.</translation>
    </message>
    <message>
      <source>No pair needs your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κανένα ζεύγος δεν χρειάζεται τη ματιά σας</translation>
    </message>
    <message numerus="yes">
      <source>%n pair(s) need your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n ζεύγος χρειάζεται τη ματιά σας</numerusform>
        <numerusform>%n ζεύγη χρειάζονται τη ματιά σας</numerusform>
      </translation>
    </message>
    <message>
      <source>Review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έλεγχος</translation>
    </message>
    <message>
      <source>Where its report is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Προς την αναφορά της</translation>
    </message>
    <message>
      <source>None of the measures of %1 is sure. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία μέτρηση της %1 δεν είναι βέβαιη. %2</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::RigPage</name>
    <message>
      <source>Two of them look alike</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δύο από αυτά μοιάζουν</translation>
    </message>
    <message>
      <source>What do you photograph with?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Με τι φωτογραφίζετε;</translation>
    </message>
    <message>
      <source>The virtual rig breaks a pot and photographs its sherds: try everything with it. A rig file (RIG.json) names your cameras and your turntable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικονική διάταξη σπάει ένα αγγείο και φωτογραφίζει τα όστρακά του: δοκιμάστε τα πάντα με αυτήν. Ένα αρχείο διάταξης (RIG.json) ονομάζει τις κάμερες και το περιστρεφόμενο τραπέζι σας.</translation>
    </message>
    <message>
      <source>Use the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρήση της εικονικής διάταξης</translation>
    </message>
    <message>
      <source>Choose a rig file…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλογή αρχείου διάταξης…</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή φωτογραφιών…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή σαρώσεων…</translation>
    </message>
    <message>
      <source>The virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικονική διάταξη</translation>
    </message>
    <message>
      <source>small: a batch in a minute or two</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μικρές: μια παρτίδα σε ένα-δύο λεπτά</translation>
    </message>
    <message>
      <source>normal</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κανονικές</translation>
    </message>
    <message>
      <source>fine: as a real camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>λεπτομερείς: όπως μια αληθινή κάμερα</translation>
    </message>
    <message>
      <source>&amp;Sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Όστρακα στον δίσκο</translation>
    </message>
    <message>
      <source>&amp;Photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Φωτογραφίες</translation>
    </message>
    <message>
      <source>%1 pixels wide</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλάτος %1 εικονοστοιχεία</translation>
    </message>
    <message>
      <source>Rig file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρχείο διάταξης</translation>
    </message>
    <message>
      <source>Rig (*.json)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάταξη (*.json)</translation>
    </message>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάστημα</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SettingsPage</name>
    <message>
      <source>As the desktop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όπως η επιφάνεια εργασίας</translation>
    </message>
    <message>
      <source>Light</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτεινό</translation>
    </message>
    <message>
      <source>Dark, for the tent</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σκούρο, για τη σκηνή</translation>
    </message>
    <message>
      <source>Sunlight: black on white, thick lines</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ηλιόφως: μαύρο σε άσπρο, παχιές γραμμές</translation>
    </message>
    <message>
      <source>all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όλα</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ρυθμίσεις</translation>
    </message>
    <message>
      <source>&amp;Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα &amp;αρχικά σας</translation>
    </message>
    <message>
      <source>They stand in the history of each decision.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναγράφονται στο ιστορικό κάθε απόφασης.</translation>
    </message>
    <message>
      <source>&amp;Theme</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Θέμα</translation>
    </message>
    <message>
      <source>Te&amp;xt size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Μέγεθος κειμένου</translation>
    </message>
    <message>
      <source>Text size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μέγεθος κειμένου</translation>
    </message>
    <message>
      <source>&amp;Language</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Γλώσσα</translation>
    </message>
    <message>
      <source>Holds from the next start.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ισχύει από την επόμενη εκκίνηση.</translation>
    </message>
    <message>
      <source>&amp;Processors for computing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Επεξεργαστές για υπολογισμό</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
      <source>Back to work (Esc)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίσω στη δουλειά (Esc)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SheetView</name>
    <message>
      <source>The drawing on its sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το σχέδιο στο φύλλο του</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdDetails</name>
    <message>
      <source>missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>λείπει</translation>
    </message>
    <message>
      <source>changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>άλλαξε</translation>
    </message>
    <message>
      <source>present</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>υπάρχει</translation>
    </message>
    <message>
      <source>Details of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στοιχεία του οστράκου</translation>
    </message>
    <message>
      <source>Number of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμός του οστράκου</translation>
    </message>
    <message>
      <source>Picture of the sherd in the way</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνα του οστράκου που εμποδίζει</translation>
    </message>
    <message>
      <source>measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μέτρο</translation>
    </message>
    <message>
      <source>value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τιμή</translation>
    </message>
    <message>
      <source>from</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>προέλευση</translation>
    </message>
    <message>
      <source>Measurements</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρήσεις</translation>
    </message>
    <message>
      <source>when</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πότε</translation>
    </message>
    <message>
      <source>who</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ποιος</translation>
    </message>
    <message>
      <source>what</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τι</translation>
    </message>
    <message>
      <source>History</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ιστορικό</translation>
    </message>
    <message>
      <source>file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχείο</translation>
    </message>
    <message>
      <source>kind</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>είδος</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κατάσταση</translation>
    </message>
    <message>
      <source>Files</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρχεία</translation>
    </message>
    <message>
      <source>Measured</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρημένα</translation>
    </message>
    <message>
      <source>Context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πλαίσιο</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλαίσιο</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χωρίς αριθμό ακόμη</translation>
    </message>
    <message>
      <source>Give the number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Απόδοση του αριθμού %1</translation>
    </message>
    <message>
      <source>added</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>προστέθηκε</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>%1: %2 → %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 → %3</translation>
    </message>
    <message>
      <source>nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τίποτα</translation>
    </message>
    <message>
      <source>program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πρόγραμμα</translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλέξτε όστρακο.</translation>
    </message>
    <message>
      <source>%1 It is %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Είναι το %2.</translation>
    </message>
    <message>
      <source>%1; in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1· αμφίβολο</translation>
    </message>
    <message>
      <source>%1 ± %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ± %2</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdEdits</name>
    <message numerus="yes">
      <source>number %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>αρίθμηση %n οστράκου</numerusform>
        <numerusform>αρίθμηση %n οστράκων</numerusform>
      </translation>
    </message>
    <message>
      <source>Other changes are still being saved; wait for them, or stop them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύονται ακόμη άλλες αλλαγές· περιμένετε, ή διακόψτε τες.</translation>
    </message>
    <message>
      <source>The sherds that are chosen have their numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα επιλεγμένα όστρακα έχουν τους αριθμούς τους.</translation>
    </message>
    <message>
      <source>Numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμοί</translation>
    </message>
    <message>
      <source>Stopped; nothing was changed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σταμάτησε· δεν άλλαξε τίποτα.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdTableModel</name>
    <message>
      <source>Picture of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνα ενός οστράκου</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>not recorded</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>δεν καταγράφηκε</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χωρίς αριθμό ακόμη</translation>
    </message>
    <message>
      <source>%1: %2, in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2, αμφίβολο</translation>
    </message>
    <message>
      <source>%1: the scale of batch %2 is in doubt; its report says why and what to do.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: η κλίμακα της παρτίδας %2 είναι αμφίβολη· η αναφορά της λέει γιατί και τι να γίνει.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdView</name>
    <message>
      <source>Sherd in three dimensions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο σε τρεις διαστάσεις</translation>
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the sherd cannot be shown in three dimensions. Everything else works; photographs and outlines are beside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η οθόνη δεν έχει OpenGL 3.2, οπότε το όστρακο δεν φαίνεται σε τρεις διαστάσεις. Όλα τα άλλα λειτουργούν· φωτογραφίες και περιγράμματα είναι δίπλα.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::StartScreen</name>
    <message>
      <source>Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka</translation>
    </message>
    <message>
      <source>Potsherds, both sides, complete and measured.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα, και οι δύο όψεις, πλήρη και μετρημένα.</translation>
    </message>
    <message>
      <source>&amp;Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Έργα</translation>
    </message>
    <message>
      <source>No project yet. Make one, or try everything with the virtual rig: it breaks a pot and photographs its sherds for you.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κανένα έργο ακόμη. Φτιάξτε ένα, ή δοκιμάστε τα πάντα με την εικονική διάταξη: σπάει ένα αγγείο και φωτογραφίζει τα όστρακά του για εσάς.</translation>
    </message>
    <message>
      <source>&amp;Open a project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Άνοιγμα έργου…</translation>
    </message>
    <message>
      <source>Try with the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμή με την εικονική διάταξη</translation>
    </message>
    <message>
      <source>New project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέο έργο</translation>
    </message>
    <message>
      <source>Aragats 2026</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aragats 2026</translation>
    </message>
    <message>
      <source>Choose…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλογή…</translation>
    </message>
    <message>
      <source>Choose the folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλογή του φακέλου</translation>
    </message>
    <message>
      <source>Make the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δημιουργία έργου</translation>
    </message>
    <message>
      <source>&amp;Name</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό&amp;νομα</translation>
    </message>
    <message>
      <source>&amp;Site code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κωδικός &amp;θέσης</translation>
    </message>
    <message>
      <source>&amp;Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Φάκελος</translation>
    </message>
    <message>
      <source>Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Α&amp;ρίθμηση</translation>
    </message>
    <message>
      <source>A sherd will be</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο θα είναι</translation>
    </message>
    <message>
      <source>%1
%2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2, %3</translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εντάξει</translation>
    </message>
    <message>
      <source>Folder of the new project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος του νέου έργου</translation>
    </message>
    <message>
      <source>Folder of a project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος ενός έργου</translation>
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έργα</translation>
    </message>
    <message>
      <source>%1
%2 is not there: find it …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
Το %2 δεν υπάρχει: βρείτε το …</translation>
    </message>
    <message>
      <source>Where is %1 now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πού είναι τώρα το %1;</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::StopBoard</name>
    <message>
      <source>Photographs of this side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες αυτής της όψης</translation>
    </message>
    <message>
      <source>%1 of %2 stops are done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έγιναν %1 από %2 στάσεις</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Thumbnails</name>
    <message>
      <source>Picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνα</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ViewOverlay</name>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>front: blue rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μπροστά: μπλε ακμή</translation>
    </message>
    <message>
      <source>back: red rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω: κόκκινη ακμή</translation>
    </message>
    <message>
      <source>%1 mm and more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm και πάνω</translation>
    </message>
    <message>
      <source>0 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>0 mm</translation>
    </message>
    <message>
      <source>gap between the sides along the rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κενό μεταξύ των όψεων κατά μήκος της ακμής</translation>
    </message>
    <message>
      <source>grey: not met by the other side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>γκρι: η άλλη πλευρά δεν φτάνει εδώ</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberEdit</name>
    <message>
      <source>7, a whole number, or scan its label</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7, ολόκληρος αριθμός ή σάρωση της ετικέτας</translation>
    </message>
    <message>
      <source>&amp;Number of sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Αριθμός του οστράκου %1</translation>
    </message>
    <message>
      <source>If they have numbers already: each follows its sherd through the flip. Key N.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αν έχουν ήδη αριθμούς: ο καθένας ακολουθεί το όστρακό του στο γύρισμα. Πλήκτρο N.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskModel</name>
    <message>
      <source>%1, camera %2, stop %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, κάμερα %2, στάση %3</translation>
    </message>
    <message>
      <source>Mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μάσκα</translation>
    </message>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μάσκες του %1</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω όψη</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μπροστινή όψη</translation>
    </message>
    <message>
      <source>paint on a mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ζωγραφική σε μάσκα</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskPage</name>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μάσκες του %1</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) mended; what follows from them is computed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n φωτογραφία διορθώθηκε· ό,τι προκύπτει από αυτήν υπολογίζεται ξανά.</numerusform>
        <numerusform>%n φωτογραφίες διορθώθηκαν· ό,τι προκύπτει από αυτές υπολογίζεται ξανά.</numerusform>
      </translation>
    </message>
    <message>
      <source>Back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίσω</translation>
    </message>
    <message>
      <source>Brush's &amp;width</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Πλάτος πινέλου</translation>
    </message>
    <message>
      <source>Compute with these</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπολογισμός με αυτές</translation>
    </message>
    <message>
      <source>Larger</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μεγέθυνση</translation>
    </message>
    <message>
      <source>Smaller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σμίκρυνση</translation>
    </message>
    <message>
      <source>Next photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επόμενη φωτογραφία</translation>
    </message>
    <message>
      <source>Photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφία</translation>
    </message>
    <message>
      <source>Photograph before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Προηγούμενη φωτογραφία</translation>
    </message>
    <message>
      <source>Plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δίσκος</translation>
    </message>
    <message>
      <source>Sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο</translation>
    </message>
    <message>
      <source>The photograph is being read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η φωτογραφία διαβάζεται.</translation>
    </message>
    <message>
      <source>What is veiled in blue is taken for sherd. Paint what is missing, or as plate what is too much; the program's own masks stay.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό,τι καλύπτεται με γαλάζιο θεωρείται όστρακο. Ζωγραφίστε ό,τι λείπει ή, ως δίσκο, ό,τι περισσεύει· οι μάσκες του προγράμματος μένουν.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskView</name>
    <message>
      <source>Photograph with its mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφία με τη μάσκα της</translation>
    </message>
    <message>
      <source>The arrows move the brush, Space paints, plus and minus enlarge and reduce.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα βέλη μετακινούν το πινέλο, το διάστημα ζωγραφίζει, το συν και το πλην μεγεθύνουν και σμικρύνουν.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberingEdit</name>
    <message>
      <source>A sherd will be</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο θα είναι</translation>
    </message>
    <message>
      <source>First number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρώτος αριθμός αυτού του υπολογιστή</translation>
    </message>
    <message>
      <source>Last number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τελευταίος αριθμός αυτού του υπολογιστή</translation>
    </message>
    <message>
      <source>Left out so far</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παραλείφθηκαν ως τώρα</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Α&amp;ρίθμηση</translation>
    </message>
    <message>
      <source>Num&amp;bers of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμοί αυτού του &amp;υπολογιστή</translation>
    </message>
    <message>
      <source>Number so from &amp;now on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρίθμηση έτσι από εδώ και &amp;πέρα</translation>
    </message>
    <message>
      <source>Numbers of the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμοί του ανοιχτού έργου</translation>
    </message>
    <message>
      <source>What has a number keeps it; the next sherds follow. No number is ever given twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό,τι έχει αριθμό τον κρατά· τα επόμενα όστρακα ακολουθούν. Κανένας αριθμός δεν δίνεται δύο φορές.</translation>
    </message>
    <message numerus="yes">
      <source>and in %n more context(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>και σε %n ακόμη πλαίσιο</numerusform>
        <numerusform>και σε %n ακόμη πλαίσια</numerusform>
      </translation>
    </message>
    <message>
      <source>no number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κανένας αριθμός</translation>
    </message>
    <message>
      <source>to</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>έως</translation>
    </message>
    <message>
      <source>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, and {n} once; {n:04} has four digits at least</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, και {n} μία φορά· το {n:04} έχει τουλάχιστον τέσσερα ψηφία</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberingModel</name>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Numbers left out</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμοί που παραλείφθηκαν</translation>
    </message>
    <message>
      <source>Sherds of %1 get no number so: it lacks a part that the numbering names.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα όστρακα του %1 δεν παίρνουν έτσι αριθμό: του λείπει ένα μέρος που αναφέρει η αρίθμηση.</translation>
    </message>
    <message>
      <source>The first number of a block is not above its last.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο πρώτος αριθμός μιας ομάδας δεν είναι πάνω από τον τελευταίο.</translation>
    </message>
    <message>
      <source>change the numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αλλαγή της αρίθμησης</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::VocabularyEdit</name>
    <message>
      <source>&amp;Save the words</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθήκευση λέ&amp;ξεων</translation>
    </message>
    <message>
      <source>&amp;Words for</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Λέξεις για</translation>
    </message>
    <message>
      <source>A word that sherds use already stays; change those first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια λέξη που ήδη χρησιμοποιούν όστρακα μένει· αλλάξτε πρώτα εκείνα.</translation>
    </message>
    <message>
      <source>&amp;One a line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μ&amp;ία ανά γραμμή</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε.</translation>
    </message>
    <message>
      <source>Words of the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λέξεις του ανοιχτού έργου</translation>
    </message>
    <message>
      <source>Words, one a line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λέξεις, μία ανά γραμμή</translation>
    </message>
    <message>
      <source>change the words</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αλλαγή των λέξεων</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διατήρηση</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διακόσμηση</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όπτηση</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κατασκευή</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μέρος</translation>
    </message>
    <message>
      <source>surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>επιφάνεια</translation>
    </message>
    <message>
      <source>These words are not saved yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτές οι λέξεις δεν έχουν αποθηκευτεί ακόμη.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CountEdit</name>
    <message>
      <source>&amp;Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό&amp;στρακα</translation>
    </message>
    <message>
      <source>not counted</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>δεν μετρήθηκαν</translation>
    </message>
    <message>
      <source>How many sherds you counted onto the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πόσα όστρακα μετρήσατε στον δίσκο</translation>
    </message>
    <message>
      <source>Count them if you like: you are asked when the photographs show another number (S)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρήστε τα αν θέλετε: ερωτάστε όταν οι φωτογραφίες δείχνουν άλλον αριθμό (S)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::RigRenewal</name>
    <message>
      <source>Calibration by %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Βαθμονόμηση από το %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportLine</name>
    <message>
      <source>How far the import is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος της εισαγωγής</translation>
    </message>
    <message>
      <source>Stop the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή της εισαγωγής</translation>
    </message>
  </context>
  <context>
    <name>ImportBatch</name>
    <message>
      <source>There are no scans (*.ply) in its folder %1/. Choose a folder that holds front/ and back/.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχουν σαρώσεις (*.ply) στον φάκελό του %1/. Επιλέξτε φάκελο που περιέχει front/ και back/.</translation>
    </message>
    <message>
      <source>This folder cannot be read to its end: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος δεν διαβάζεται ως το τέλος: %1.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdNumbers</name>
    <message>
      <source>%1 is no sherd's number: it has a digit, no space and at most %2 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 δεν είναι αριθμός οστράκου: έχει ένα ψηφίο, κανένα κενό και το πολύ %2 χαρακτήρες.</translation>
    </message>
    <message>
      <source>Sherd %1 of this plate has the number %2: take it from that one first, or type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όστρακο %1 αυτού του δίσκου έχει τον αριθμό %2: αφαιρέστε τον πρώτα από εκείνο ή γράψτε άλλον.</translation>
    </message>
    <message>
      <source>A sherd of %1 has the number %2 already; type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο της %1 έχει ήδη τον αριθμό %2· γράψτε άλλον.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Doubts</name>
    <message>
      <source>the file is cut off or no picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το αρχείο είναι κομμένο ή δεν είναι εικόνα</translation>
    </message>
    <message>
      <source>the markers show another angle than this stop's</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>οι δείκτες δείχνουν άλλη γωνία από αυτήν της στάσης</translation>
    </message>
    <message>
      <source>the picture has another size than the camera's others</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η εικόνα έχει άλλο μέγεθος από τις άλλες της κάμερας</translation>
    </message>
    <message>
      <source>too few markers are seen to tell the stop: is something before them, is it blurred?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>φαίνονται πολύ λίγοι δείκτες για να βρεθεί η στάση: υπάρχει κάτι μπροστά τους, είναι θολή;</translation>
    </message>
    <message>
      <source>the camera handed over an earlier photograph once more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η κάμερα παρέδωσε ξανά μια παλιότερη φωτογραφία</translation>
    </message>
    <message>
      <source>too few markers of the plate are seen: is something before them?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>φαίνονται πολύ λίγοι δείκτες του δίσκου: υπάρχει κάτι μπροστά τους;</translation>
    </message>
    <message>
      <source>it is blurred: did the table still move, did the focus change?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>είναι θολή: κουνιόταν ακόμη το τραπέζι, άλλαξε η εστίαση;</translation>
    </message>
    <message>
      <source>the sherds are too dark: give more light or expose longer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τα όστρακα είναι πολύ σκοτεινά: δώστε περισσότερο φως ή μεγαλύτερη έκθεση</translation>
    </message>
    <message>
      <source>the sherds are burnt out: expose shorter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τα όστρακα είναι υπερεκτεθειμένα: μικρότερη έκθεση</translation>
    </message>
    <message>
      <source>a sherd is cut off by the picture's edge: move it or the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το άκρο της εικόνας κόβει ένα όστρακο: μετακινήστε το ή την κάμερα</translation>
    </message>
    <message>
      <source>the camera's settings are others than they were: set them back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>οι ρυθμίσεις της κάμερας άλλαξαν: επαναφέρετέ τες</translation>
    </message>
    <message>
      <source>(%1, %2) mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>(%1, %2) mm</translation>
    </message>
    <message>
      <source>%1: set it back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: επαναφέρετέ το</translation>
    </message>
    <message>
      <source>The sherds could not be counted: too few of the plate's markers are seen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα όστρακα δεν μετρήθηκαν: φαίνονται πολύ λίγοι δείκτες του δίσκου.</translation>
    </message>
    <message>
      <source>No sherd is seen on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν φαίνεται κανένα όστρακο στον δίσκο.</translation>
    </message>
    <message>
      <source>Sherds touch or nearly touch at %1 from the plate's middle: move them apart and shoot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα αγγίζονται ή σχεδόν αγγίζονται στο %1 από το μέσο του δίσκου: απομακρύνετέ τα και φωτογραφίστε ξανά.</translation>
    </message>
    <message>
      <source>What lies at %1 from the plate's middle was counted as one but may be two sherds that touch: look there; if so, move them apart and shoot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό,τι βρίσκεται στο %1 από το μέσο του δίσκου μετρήθηκε ως ένα, ίσως όμως είναι δύο όστρακα που αγγίζονται: κοιτάξτε εκεί· αν είναι έτσι, απομακρύνετέ τα και φωτογραφίστε ξανά.</translation>
    </message>
    <message>
      <source>The back looks like the front: turn the sherds over and photograph them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη μοιάζει με την μπροστινή: γυρίστε τα όστρακα και φωτογραφίστε τα ξανά.</translation>
    </message>
    <message>
      <source>The sherds of the back could not be counted: compare the pictures yourself before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα όστρακα της πίσω όψης δεν μετρήθηκαν: συγκρίνετε μόνοι σας τις εικόνες πριν αδειάσετε τον δίσκο.</translation>
    </message>
    <message>
      <source>The sherds of the front could not be counted: compare the pictures yourself before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα όστρακα της μπροστινής όψης δεν μετρήθηκαν: συγκρίνετε μόνοι σας τις εικόνες πριν αδειάσετε τον δίσκο.</translation>
    </message>
    <message>
      <source>The front showed %1 sherds, the back %2: look for the missing one before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μπροστινή όψη έδειξε %1 όστρακα, η πίσω %2: αναζητήστε αυτό που λείπει πριν αδειάσετε τον δίσκο.</translation>
    </message>
    <message>
      <source>The front showed %1 sherds, the back %2: was one added, or did one break?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μπροστινή όψη έδειξε %1 όστρακα, η πίσω %2: προστέθηκε κάποιο ή έσπασε κάποιο;</translation>
    </message>
  </context>
  <context>
    <name>ostraka::Error</name>
    <message>
      <source>Stopped on request.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακόπηκε κατόπιν αιτήματος.</translation>
    </message>
    <message>
      <source>The camera is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν είναι συνδεδεμένη.</translation>
    </message>
    <message>
      <source>The camera is not plugged in or not switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν είναι συνδεδεμένη ή δεν είναι ανοιχτή.</translation>
    </message>
    <message>
      <source>The camera does not answer; is it asleep? Switch its automatic power-off off.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν απαντά· κοιμάται; Απενεργοποιήστε την αυτόματη διακοπή της.</translation>
    </message>
    <message>
      <source>The camera stays busy; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα παραμένει απασχολημένη· κλείστε την και ανοίξτε την.</translation>
    </message>
    <message>
      <source>The line to the camera is broken; look at its cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σύνδεση με την κάμερα διακόπηκε· ελέγξτε το καλώδιό της.</translation>
    </message>
    <message>
      <source>The camera is held by another program, often the desktop's file manager; 'ostraka devices' names it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα άλλο πρόγραμμα κρατά την κάμερα, συχνά η διαχείριση αρχείων· το 'ostraka devices' το ονομάζει.</translation>
    </message>
    <message>
      <source>The camera cannot be opened; may this user use it? Look at 'ostraka devices'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν ανοίγει· επιτρέπεται σε αυτόν τον χρήστη; Δείτε 'ostraka devices'.</translation>
    </message>
    <message>
      <source>No photograph came from the camera; is it focused and set to manual?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν ήρθε φωτογραφία από την κάμερα· είναι εστιασμένη και σε χειροκίνητη λειτουργία;</translation>
    </message>
    <message>
      <source>The camera does not stop to deliver photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν σταματά να παραδίδει φωτογραφίες.</translation>
    </message>
    <message>
      <source>This camera shows no live picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η κάμερα δεν δείχνει ζωντανή εικόνα.</translation>
    </message>
    <message>
      <source>The turntable does not reach its angle; is it blocked?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν φτάνει στη γωνία του· είναι μπλοκαρισμένο;</translation>
    </message>
    <message>
      <source>The turntable was paused at its own button.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι σταμάτησε από το δικό του κουμπί.</translation>
    </message>
    <message>
      <source>The table's position is not known: home it, or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η θέση του τραπεζιού δεν είναι γνωστή: μηδενίστε ή ευθυγραμμίστε το.</translation>
    </message>
    <message>
      <source>The turntable does not answer in the network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν απαντά στο δίκτυο.</translation>
    </message>
    <message>
      <source>The controller restarted; the table's position is not known.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο ελεγκτής επανεκκίνησε· η θέση του τραπεζιού δεν είναι γνωστή.</translation>
    </message>
    <message>
      <source>A reply of the turntable was lost and it cannot tell where it stands: home it, or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χάθηκε μια απάντηση του τραπεζιού και δεν μπορεί να πει πού βρίσκεται: μηδενίστε ή ευθυγραμμίστε το.</translation>
    </message>
    <message>
      <source>The turntable does not answer like a GRBL controller: is it switched on, and is it of this type?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τραπέζι δεν απαντά σαν ελεγκτής GRBL: είναι ανοιχτό και αυτού του τύπου;</translation>
    </message>
    <message>
      <source>The turntable does not answer like a ComXim: is it switched on, and is it of this type?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τραπέζι δεν απαντά σαν ComXim: είναι ανοιχτό και αυτού του τύπου;</translation>
    </message>
    <message>
      <source>USB does not work on this computer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το USB δεν λειτουργεί σε αυτόν τον υπολογιστή.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and shoot on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δίσκος είναι γεμάτος· ελευθερώστε χώρο και συνεχίστε τη λήψη.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and start the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δίσκος είναι γεμάτος· ελευθερώστε χώρο και ξεκινήστε ξανά το ίδιο.</translation>
    </message>
    <message>
      <source>The disk is full; make room, then try again. Nothing was lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δίσκος είναι γεμάτος· κάντε χώρο και δοκιμάστε ξανά. Τίποτα δεν χάθηκε.</translation>
    </message>
    <message>
      <source>Another program keeps the catalogue busy; close it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα άλλο πρόγραμμα κρατά απασχολημένο τον κατάλογο· κλείστε το και δοκιμάστε ξανά.</translation>
    </message>
    <message>
      <source>The image is cut off before its end; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα είναι κομμένη πριν από το τέλος της· αντιγράψτε την ξανά από την κάμερα.</translation>
    </message>
  </context>
</TS>
