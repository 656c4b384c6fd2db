"""The studio: a page on this machine to arrange a plan, change it by hand and take it away.

The server's document is the truth: the page shows it and sends verbs (:mod:`.session`), each of
which adds a version to a project file (:mod:`.project`); what the page draws is plain data
(:mod:`.drawable`). Only this machine's browser is let in (:mod:`.guard`).
"""
